#include "robot/laser/core/lms_telegram.hpp"

#include <gtest/gtest.h>

#include "robot/laser/core/lms_message.hpp"
#include "services/common/random.hpp"

namespace tandem::lms {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes request(const Payload& payload) {
  const std::string bytes = bytes_of(kToLaser, payload);
  return {bytes.begin(), bytes.end()};
}

Bytes scan_bytes(std::uint16_t first_value) {
  ScanData scan{.values = std::vector<std::uint16_t>(361, 1000)};
  scan.values[0] = first_value;
  const std::string bytes = bytes_of(kFromLaser, payload_of(scan));
  return {bytes.begin(), bytes.end()};
}

/// The first value of each scan among `events`.
std::vector<int> first_values(const std::vector<Event>& events) {
  std::vector<int> values;
  for (const Event& event : events) {
    if (const auto scan = parse_scan(event.payload)) values.push_back(scan->values[0]);
  }
  return values;
}

TEST(LmsTelegram, HasTheBytesOfTheManual) {
  EXPECT_EQ(request({command::kStatus}), (Bytes{0x02, 0x00, 0x01, 0x00, 0x31, 0x15, 0x12}));
  EXPECT_EQ(request({command::kType}), (Bytes{0x02, 0x00, 0x01, 0x00, 0x3A, 0x1E, 0x12}));
  EXPECT_EQ(request({command::kReset}), (Bytes{0x02, 0x00, 0x01, 0x00, 0x10, 0x34, 0x12}));
  EXPECT_EQ(request(mode_request(*mode_of_rate(38'400))), (Bytes{0x02, 0x00, 0x02, 0x00, 0x20, 0x40, 0x50, 0x08}));
  EXPECT_EQ(request(mode_request(mode::kStream)), (Bytes{0x02, 0x00, 0x02, 0x00, 0x20, 0x24, 0x34, 0x08}));
  EXPECT_EQ(request(mode_request(mode::kOnRequest)), (Bytes{0x02, 0x00, 0x02, 0x00, 0x20, 0x25, 0x35, 0x08}));
  EXPECT_EQ(request(variant_request({.field_deg = 180, .step_centideg = 50})),
            (Bytes{0x02, 0x00, 0x05, 0x00, 0x3B, 0xB4, 0x00, 0x32, 0x00, 0x3B, 0x1F}));
  EXPECT_EQ(request(mode_request(mode::kInstallation)),
            (Bytes{0x02, 0x00, 0x0A, 0x00, 0x20, 0x00, 0x53, 0x49, 0x43, 0x4B, 0x5F, 0x4C, 0x4D, 0x53, 0xBE, 0xC5}));
}

TEST(LmsTelegram, TellsTheSingleBytesFromTelegrams) {
  TelegramReader reader{kFromLaser};
  Bytes bytes{kAcknowledged, kRefused};
  const Bytes scan = scan_bytes(7);
  bytes.insert(bytes.end(), scan.begin(), scan.end());
  const auto events = reader.take(bytes);
  ASSERT_EQ(events.size(), 3u);
  EXPECT_EQ(events[0].kind, Event::Kind::Acknowledged);
  EXPECT_EQ(events[1].kind, Event::Kind::Refused);
  EXPECT_EQ(first_values(events), std::vector<int>{7});
}

TEST(LmsTelegram, IsPutTogetherFromSingleBytes) {
  TelegramReader reader{kFromLaser};
  std::vector<int> values;
  for (const std::uint8_t byte : scan_bytes(42)) {
    for (const int value : first_values(reader.take({&byte, 1}))) values.push_back(value);
  }
  EXPECT_EQ(values, std::vector<int>{42});
  EXPECT_EQ(reader.damaged(), 0u);
}

TEST(LmsTelegram, MayBeSplitAnywhere) {
  const Bytes scan = scan_bytes(42);
  for (std::size_t split = 0; split <= scan.size(); ++split) {
    TelegramReader reader{kFromLaser};
    const std::span<const std::uint8_t> all{scan};
    auto events = reader.take(all.first(split));
    for (Event& event : reader.take(all.subspan(split))) events.push_back(std::move(event));
    ASSERT_EQ(first_values(events), std::vector<int>{42}) << "split after " << split;
  }
}

TEST(LmsTelegram, ADamagedOneIsCountedAndTheNextIsRead) {
  const Bytes good = scan_bytes(2);
  for (std::size_t at = 0; at < good.size(); ++at) {
    TelegramReader reader{kFromLaser};
    Bytes bytes = scan_bytes(1);
    bytes[at] ^= 0x55;
    for (int i = 0; i < 2; ++i) bytes.insert(bytes.end(), good.begin(), good.end());
    const auto values = first_values(reader.take(bytes));
    ASSERT_GE(values.size(), 1u) << "byte " << at;
    ASSERT_EQ(values.back(), 2) << "byte " << at;
  }
}

TEST(LmsTelegram, IsFoundWithinTwoFramesAfterNoise) {
  Rng rng{11};
  for (int round = 0; round < 500; ++round) {
    TelegramReader reader{kFromLaser};
    Bytes bytes(rng.index(2000));
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(rng.bits());
    for (int i = 1; i <= 3; ++i) {
      const Bytes scan = scan_bytes(static_cast<std::uint16_t>(i));
      bytes.insert(bytes.end(), scan.begin(), scan.end());
    }
    std::vector<int> values;
    for (const std::uint8_t byte : bytes) {
      for (const int value : first_values(reader.take({&byte, 1}))) values.push_back(value);
    }
    ASSERT_GE(values.size(), 2u) << "round " << round;
    ASSERT_EQ(values.back(), 3) << "round " << round;
  }
}

TEST(LmsTelegram, OneThatClaimsAnImpossibleLengthHoldsNothingUp) {
  TelegramReader reader{kFromLaser};
  Bytes bytes{0x02, 0x80, 0xFF, 0xFF, 0x02, 0x80, 0x00, 0x00};
  const Bytes scan = scan_bytes(9);
  bytes.insert(bytes.end(), scan.begin(), scan.end());
  EXPECT_EQ(first_values(reader.take(bytes)), std::vector<int>{9});
  EXPECT_EQ(reader.damaged(), 2u);
}

}  // namespace
}  // namespace tandem::lms
