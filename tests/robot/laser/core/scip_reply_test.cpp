#include "robot/laser/core/scip_reply.hpp"

#include <gtest/gtest.h>

#include "services/common/random.hpp"

namespace tandem::scip {
namespace {

std::vector<Reply> replies_in(ReplyParser& parser, std::string_view text) {
  return parser.take(std::span{reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

/// What a parser that starts with `bytes` makes of them as one scan.
std::optional<ScanData> scan_in(std::string_view bytes) {
  ReplyParser parser;
  const auto replies = replies_in(parser, bytes);
  return replies.size() == 1 ? parse_scan(replies[0]) : std::nullopt;
}

ScanData random_scan(Rng& rng, const std::string& command) {
  ScanData scan{.request = {.command = command, .first_step = 10, .last_step = 10 + static_cast<int>(rng.index(200))},
                .timestamp_ms = static_cast<std::uint32_t>(rng.bits() & 0xFFFFFF),
                .ranges_mm = {},
                .intensities = {}};
  if (is_single(command)) scan.request.count = 1;
  for (std::size_t i = 0; i < value_count(scan.request); ++i) {
    scan.ranges_mm.push_back(static_cast<std::uint32_t>(rng.index(4096)));
    if (command[1] == 'E') scan.intensities.push_back(static_cast<std::uint32_t>(rng.index(200'000)));
  }
  return scan;
}

TEST(ScipReply, HasEchoStatusDataAndAnEmptyLine) {
  EXPECT_EQ(bytes_of(Reply{.echo = "QT", .status = "00", .data = {}}), "QT\n00P\n\n");
  // 0x44 + 0x4D + 0x49 + 0x4E + 0x3A + 0x32 + 0x33 = 0x1C7; low six bits 0x07, so '7'; the ';' does not count
  EXPECT_EQ(bytes_of(Reply{.echo = "PP", .status = "00", .data = {"DMIN:23"}}), "PP\n00P\nDMIN:23;7\n\n");
}

TEST(ScipReply, IsUnderstoodByteByByte) {
  ReplyParser parser;
  std::vector<Reply> all;
  for (const char c : std::string{"PP\n00P\nDMIN:23;7\n\nBM\n02R\n\n"}) {
    for (Reply& reply : replies_in(parser, {&c, 1})) all.push_back(std::move(reply));
  }
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].echo, "PP");
  EXPECT_EQ(all[0].data, std::vector<std::string>{"DMIN:23"});
  EXPECT_EQ(all[1].status, "02");
  EXPECT_EQ(parser.damaged(), 0u);
}

TEST(ScipReply, OfAnOldSensorHasAStatusWithoutChecksum) {
  ReplyParser parser;
  const auto replies = replies_in(parser, "QT\nE\n\n");
  ASSERT_EQ(replies.size(), 1u);
  EXPECT_EQ(replies[0].status, "E");
}

TEST(ScipReply, IsDroppedAndCountedWhenAChecksumIsWrong) {
  ReplyParser parser;
  EXPECT_TRUE(replies_in(parser, "PP\n00P\nDMIN:24;7\n\n").empty());  // was 23
  EXPECT_TRUE(replies_in(parser, "QT\n00Q\n\n").empty());
  EXPECT_EQ(parser.damaged(), 2u);
  EXPECT_EQ(replies_in(parser, "QT\n00P\n\n").size(), 1u);
}

TEST(ScipReply, AfterTheRestOfAnotherIsUnderstood) {
  const ScanData scan{.request = {.first_step = 0, .last_step = 99},
                      .ranges_mm = std::vector<std::uint32_t>(100, 1000)};
  const std::string former = bytes_of(scan);
  ReplyParser parser;
  const auto replies = replies_in(parser, former.substr(former.size() / 2) + "QT\n00P\n\n");
  ASSERT_EQ(replies.size(), 1u);
  EXPECT_EQ(replies[0].echo, "QT");
}

TEST(ScipScan, JoinsItsLinesBeforeItDecodes) {
  ScanData scan{.request = {.first_step = 0, .last_step = 21},  // 22 values of 3 characters: 64 + 2
                .timestamp_ms = 16'000'000,
                .ranges_mm = std::vector<std::uint32_t>(22, 5432),
                .intensities = {}};
  const std::string bytes = bytes_of(scan);
  EXPECT_TRUE(bytes.starts_with("MD0000002101000\n99b\nm2@0"));
  EXPECT_NE(bytes.find("\nDh"), std::string::npos);  // "1Dh" is split after its first character
  EXPECT_EQ(scan_in(bytes), scan);
}

TEST(ScipScan, ComesBackFromAnyEncoding) {
  Rng rng{11};
  for (const char* command : {"MD", "MS", "ME", "GD", "GS", "GE"}) {
    for (int i = 0; i < 50; ++i) {
      const ScanData scan = random_scan(rng, command);
      EXPECT_EQ(scan_in(bytes_of(scan)), scan) << command << " " << i;
    }
  }
}

TEST(ScipScan, WithAWrongCountOfValuesIsNone) {
  ScanData scan{.request = {.first_step = 0, .last_step = 9}, .ranges_mm = std::vector<std::uint32_t>(9, 1000)};
  EXPECT_FALSE(scan_in(bytes_of(scan)));
  scan.ranges_mm.clear();
  EXPECT_FALSE(scan_in(bytes_of(scan)));
  scan.ranges_mm.assign(10, 1000);
  EXPECT_TRUE(scan_in(bytes_of(scan)));
}

TEST(ScipReply, NeverFailsOnBytesTurnedAround) {
  Rng rng{3};
  ReplyParser parser;
  const std::string good = bytes_of(random_scan(rng, "MD"));
  for (int i = 0; i < 2000; ++i) {
    std::string bad = good;
    for (int flips = 0; flips < 3; ++flips) bad[rng.index(bad.size())] = static_cast<char>(rng.bits());
    for (const Reply& reply : replies_in(parser, bad)) (void)parse_scan(reply);
  }
  (void)replies_in(parser, "\n\n");
  EXPECT_EQ(replies_in(parser, good).size(), 1u);
}

}  // namespace
}  // namespace tandem::scip
