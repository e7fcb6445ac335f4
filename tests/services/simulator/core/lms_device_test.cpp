#include "services/simulator/core/lms_device.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tandem::simulator {
namespace {

using lms::Payload;

constexpr Duration kTurn = from_seconds(2.0 / 75.0);

std::vector<std::uint8_t> bytes_in(const std::string& text) {
  return {text.begin(), text.end()};
}

std::string send(LmsDevice& device, const Payload& payload) {
  return device.receive(bytes_in(lms::bytes_of(lms::kToLaser, payload)), Time{});
}

/// The payload of the one telegram in `bytes`; empty if there is none.
Payload payload_in(const std::string& bytes) {
  lms::TelegramReader reader{lms::kFromLaser};
  for (lms::Event& event : reader.take(bytes_in(bytes))) {
    if (event.kind == lms::Event::Kind::Telegram) return std::move(event.payload);
  }
  return {};
}

std::vector<double> two_metres(std::span<const Beam> beams) {
  std::vector<double> ranges(beams.size(), 2.0);
  ranges.back() = std::numeric_limits<double>::quiet_NaN();
  return ranges;
}

/// A device that has said hello.
LmsDevice awake(LmsOptions options = {}) {
  LmsDevice device{std::move(options), Time{}};
  EXPECT_EQ(payload_in(device.end_turn(Time{}, two_metres))[0], lms::command::kPowerOn);
  return device;
}

TEST(LmsDevice, AcknowledgesEachRequestBeforeItAnswers) {
  LmsDevice device = awake();
  const std::string bytes = send(device, {lms::command::kStatus});
  EXPECT_EQ(static_cast<std::uint8_t>(bytes[0]), lms::kAcknowledged);
  const Payload status = payload_in(bytes);
  EXPECT_EQ(status[0], 0xB1);
  EXPECT_EQ(status[107], 180);
  EXPECT_EQ(status[109], 50);
}

TEST(LmsDevice, RefusesWhatItDoesNotUnderstand) {
  LmsDevice device = awake();
  EXPECT_EQ(send(device, {0x66}), std::string(1, lms::kRefused));
  std::string broken = lms::bytes_of(lms::kToLaser, Payload{lms::command::kStatus});
  broken.back() ^= 1;
  EXPECT_EQ(device.receive(bytes_in(broken), Time{}), std::string(1, lms::kRefused));
}

TEST(LmsDevice, HearsNothingAtAWrongRateAndSaysNothingSensible) {
  LmsDevice device{{}, Time{}};
  device.set_line_rate(38'400);
  EXPECT_TRUE(payload_in(device.end_turn(Time{}, two_metres)).empty());
  EXPECT_EQ(send(device, {lms::command::kStatus}), "");
  device.set_line_rate(9'600);
  EXPECT_FALSE(payload_in(send(device, {lms::command::kStatus})).empty());
}

TEST(LmsDevice, ChangesItsRateAfterTheAnswer) {
  LmsDevice device = awake();
  device.set_line_rate(9'600);
  EXPECT_EQ(payload_in(send(device, lms::mode_request(0x40))), (Payload{0xA0, 0x00, 0x00}));
  EXPECT_EQ(device.baud_rate(), 38'400);
  EXPECT_EQ(send(device, {lms::command::kStatus}), "");
  device.set_line_rate(38'400);
  EXPECT_FALSE(payload_in(send(device, {lms::command::kStatus})).empty());
}

TEST(LmsDevice, StreamsAsFastAsTheLineCarries) {
  LmsDevice device = awake();
  (void)send(device, lms::mode_request(0x40));
  EXPECT_FALSE(device.is_measuring());
  (void)send(device, lms::mode_request(lms::mode::kStream));
  int scans = 0;
  for (Time now{}; now < Time{} + from_seconds(10.0); now += kTurn) {
    const std::string bytes = device.end_turn(now, two_metres);
    if (bytes.empty()) continue;
    ++scans;
    const auto scan = lms::parse_scan(payload_in(bytes));
    ASSERT_TRUE(scan);
    ASSERT_EQ(scan->values.size(), 361u);
    EXPECT_EQ(scan->values.front(), 2000);
    EXPECT_EQ(scan->values.back(), 8183);  // out of range
  }
  EXPECT_NEAR(scans, 52, 6);  // 732 bytes at 38400 baud: 5.2 a second, in whole scans of the mirror
  (void)send(device, lms::mode_request(lms::mode::kOnRequest));
  EXPECT_FALSE(device.is_measuring());
}

TEST(LmsDevice, GivesOneScanOnRequest) {
  LmsDevice device = awake();
  (void)send(device, {lms::command::kScan, 1});
  EXPECT_TRUE(device.is_measuring());
  EXPECT_TRUE(lms::parse_scan(payload_in(device.end_turn(Time{}, two_metres))));
  EXPECT_FALSE(device.is_measuring());
}

TEST(LmsDevice, TakesFieldsOfViewThatExist) {
  LmsDevice device = awake();
  EXPECT_EQ(payload_in(send(device, lms::variant_request({100, 25})))[1], 1);
  EXPECT_EQ(payload_in(send(device, lms::variant_request({180, 25})))[1], 0);
  (void)send(device, {lms::command::kScan, 1});
  EXPECT_EQ(lms::parse_scan(payload_in(device.end_turn(Time{}, two_metres)))->values.size(), 401u);
}

TEST(LmsDevice, ItsConfigurationIsWrittenWithThePasswordOnly) {
  LmsDevice device = awake();
  const Payload read = payload_in(send(device, {lms::command::kReadConfig}));
  const lms::ConfigBlock block{read.begin() + 1, read.end() - 1};
  Payload write{lms::command::kWriteConfig};
  const auto wanted = lms::with_format(block, {.measuring_mode = 6, .millimetres = true});
  write.insert(write.end(), wanted.begin(), wanted.end());

  EXPECT_EQ(payload_in(send(device, write))[1], 0);
  EXPECT_EQ(payload_in(send(device, {lms::command::kMode, 0x00, 'X'}))[1], 1);
  EXPECT_EQ(payload_in(send(device, write))[1], 0);
  EXPECT_EQ(payload_in(send(device, lms::mode_request(lms::mode::kInstallation)))[1], 0);
  EXPECT_EQ(payload_in(send(device, write))[1], 1);
  EXPECT_EQ(device.flash_writes(), 1);
}

TEST(LmsDevice, SaysWithEachAnswerThatItsWindowIsDirty) {
  LmsDevice device = awake({.polluted = true});
  EXPECT_EQ(payload_in(send(device, {lms::command::kType})).back(), lms::kPolluted);
}

}  // namespace
}  // namespace tandem::simulator
