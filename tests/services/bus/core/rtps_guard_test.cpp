#include "services/bus/core/rtps_guard.hpp"

#include <gtest/gtest.h>

#include "tests/support/rtps_datagram.hpp"

namespace tandem::bus {
namespace {

using std::chrono::milliseconds;
using test::RtpsDatagram;

const RtpsDatagram::Bytes kPayload{0, 1, 0, 0, 42, 0, 0, 0};
constexpr Time kNow = Time{std::chrono::seconds{100}};

/// What a guard of an open link that has heard samples up to 50 says.
std::optional<RtpsFault> after_fifty(const RtpsDatagram& datagram) {
  RtpsGuard guard{false};
  EXPECT_FALSE(guard.fault_of(RtpsDatagram{}.data(50, kPayload).bytes(), kNow));
  return guard.fault_of(datagram.bytes(), kNow);
}

TEST(RtpsGuard, WhatPeersSayPasses) {
  const std::pair<const char*, RtpsDatagram> rows[] = {
      {"the next sample", RtpsDatagram{}.data(51, kPayload)},
      {"a sample again", RtpsDatagram{}.data(50, kPayload)},
      {"an old one", RtpsDatagram{}.data(1, kPayload)},
      {"after many lost ones", RtpsDatagram{}.data(1'050, kPayload)},
      {"a heartbeat", RtpsDatagram{}.heartbeat(1, 50)},
      {"a heartbeat of a writer that has nothing", RtpsDatagram{}.heartbeat(51, 50)},
      {"a heartbeat of a writer that never had", RtpsDatagram{}.between({0, 0, 9, 2}, {}).heartbeat(1, 0)},
      {"a gap", RtpsDatagram{}.gap(2, 49)},
      {"a long gap, and the heartbeat of a new writer behind it",
       RtpsDatagram{}.between({0, 0, 9, 2}, {}).gap(1, 5'000).heartbeat(5'001, 5'000)},
      {"a reader that has nothing yet", RtpsDatagram{}.answer(0, 0)},
      {"an answer", RtpsDatagram{}.answer(51, 256)},
      {"a writer that has been there long", RtpsDatagram{}.between({0, 0, 9, 2}, {}).data(123'456'789, kPayload)},
  };
  for (const auto& [what, datagram] : rows) EXPECT_FALSE(after_fifty(datagram)) << what;
}

TEST(RtpsGuard, NumbersNobodyCanHaveComeToDoNot) {
  const std::pair<const char*, RtpsDatagram> rows[] = {
      {"sample 0", RtpsDatagram{}.data(0, kPayload)},
      {"a negative sample", RtpsDatagram{}.data(-5, kPayload)},
      {"a sample far ahead", RtpsDatagram{}.data(1'051, kPayload)},
      {"the last sample of all", RtpsDatagram{}.data(INT64_MAX, kPayload)},
      {"a new writer's sample far beyond", RtpsDatagram{}.between({0, 0, 9, 2}, {}).data(1'000'000'001, kPayload)},
      {"a piece of a sample far ahead", RtpsDatagram{}.data_fragment(1'051, 1, 8, 12)},
      {"a heartbeat from 0", RtpsDatagram{}.heartbeat(0, 50)},
      {"a heartbeat far ahead", RtpsDatagram{}.heartbeat(1, 1'051)},
      {"a heartbeat that runs back", RtpsDatagram{}.heartbeat(10, 8)},
      {"a gap from 0", RtpsDatagram{}.gap(0, 10)},
      {"a gap that runs back", RtpsDatagram{}.gap(10, 5)},
      {"a gap up to far ahead", RtpsDatagram{}.gap(51, 1'051)},
      {"a gap without end", RtpsDatagram{}.gap(51, INT64_MAX - 1)},
      {"a gap of an unknown writer", RtpsDatagram{}.between({0, 0, 9, 2}, {}).gap(1, 5'000)},
      {"a negative answer", RtpsDatagram{}.answer(-1, 0)},
  };
  for (const auto& [what, datagram] : rows) EXPECT_EQ(after_fifty(datagram), RtpsFault::Numbers) << what;
}

TEST(RtpsGuard, AGapIsAsLongAsWhatAWriterHasSaidAndNeverLongerThanReadersCanBear) {
  RtpsGuard guard{false};
  EXPECT_FALSE(guard.fault_of(RtpsDatagram{}.heartbeat(1, 900'000'000).bytes(), kNow));
  EXPECT_FALSE(guard.fault_of(RtpsDatagram{}.gap(800'000'001, 810'000'000).bytes(), kNow));
  EXPECT_EQ(guard.fault_of(RtpsDatagram{}.gap(1, 900'000'000).bytes(), kNow), RtpsFault::Numbers);
}

TEST(RtpsGuard, AJumpIsBelievedWhenItIsSaidAgainLater) {
  RtpsGuard guard{false};
  const auto said = [&](std::int64_t number, Time now) {
    return !guard.fault_of(RtpsDatagram{}.data(number, kPayload).bytes(), now);
  };
  EXPECT_TRUE(said(50, kNow));
  EXPECT_FALSE(said(9'000, kNow));
  EXPECT_FALSE(said(9'000, kNow + milliseconds{1}));    // the same datagram at another port
  EXPECT_TRUE(said(51, kNow + milliseconds{10}));       // a forged one changes nothing for the true ones
  EXPECT_FALSE(said(70'000, kNow + milliseconds{30}));  // nor does another forged one make the first true
  EXPECT_FALSE(said(9'001, kNow + milliseconds{40}));
  EXPECT_TRUE(said(9'002, kNow + milliseconds{90}));  // a writer that was out of reach for long, and is back
  EXPECT_TRUE(said(10'000, kNow + milliseconds{91}));
}

TEST(RtpsGuard, AnswersAreCountedForEachReaderAndWriter) {
  RtpsGuard guard{false};
  const auto passes = [&](std::uint8_t writer, std::int64_t base) {
    return !guard.fault_of(RtpsDatagram{}.between({0, 0, writer, 2}, {0, 0, 5, 7}).answer(base, 0).bytes(), kNow);
  };
  EXPECT_TRUE(passes(1, 0));
  EXPECT_TRUE(passes(1, 20'000));  // the first that says something
  EXPECT_TRUE(passes(2, 3));
  EXPECT_FALSE(passes(2, 20'000));
  EXPECT_TRUE(passes(1, 20'100));
}

TEST(RtpsGuard, OnASecuredLinkOnlyAnnouncementsAndTheHandshakeAreInTheClear) {
  struct Row {
    const char* what;
    RtpsDatagram::Entity writer;
    bool passes;
  };
  const Row rows[] = {{"a topic with keys", {0, 0, 1, 2}, false},
                      {"a topic without", {0, 0, 1, 3}, false},
                      {"a secured announcement of writers", {0xff, 0, 3, 0xc2}, false},
                      {"the exchange of keys", {0xff, 2, 2, 0xc3}, false},
                      {"the handshake", {0, 2, 1, 0xc3}, true},
                      {"announcements of participants", {0, 1, 0, 0xc2}, true},
                      {"announcements of writers", {0, 0, 3, 0xc2}, true}};
  for (const auto& row : rows) {
    for (const auto& datagram :
         {RtpsDatagram{}.between(row.writer, {}).data(1, {1, 0, 0, 0}, 0x02),
          RtpsDatagram{}.between(row.writer, {}).heartbeat(1, 1), RtpsDatagram{}.between(row.writer, {}).gap(1, 1),
          RtpsDatagram{}.between(row.writer, {}).answer(1, 0)}) {
      EXPECT_EQ(RtpsGuard{true}.fault_of(datagram.bytes(), kNow),
                row.passes ? std::nullopt : std::optional{RtpsFault::Unprotected})
          << row.what;
      EXPECT_FALSE(RtpsGuard{false}.fault_of(datagram.bytes(), kNow)) << row.what;
    }
  }
}

TEST(RtpsGuard, NoisePassesNowhere) {
  EXPECT_EQ(RtpsGuard{false}.fault_of(kPayload, kNow), RtpsFault::NoMessage);
  EXPECT_EQ(RtpsGuard{true}.fault_of(kPayload, kNow), RtpsFault::NoMessage);
}

TEST(RtpsGuard, MadeUpParticipantsDoNotFillTheMemory) {
  RtpsGuard guard{false};
  for (std::uint32_t i = 0; i < 2 * RtpsGuard::kMostAccounts; ++i) {
    std::array<std::uint8_t, 12> participant{};
    for (std::size_t byte = 0; byte < 4; ++byte) participant[byte] = static_cast<std::uint8_t>(i >> 8 * byte);
    EXPECT_FALSE(guard.fault_of(RtpsDatagram{participant}.data(1, kPayload).bytes(), kNow));
  }
  EXPECT_LE(guard.accounts(), RtpsGuard::kMostAccounts);
}

}  // namespace
}  // namespace tandem::bus
