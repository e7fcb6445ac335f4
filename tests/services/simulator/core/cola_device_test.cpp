#include "services/simulator/core/cola_device.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tandem::simulator {
namespace {

std::string send(ColaDevice& device, const std::string& text, Time now = Time{}) {
  const std::string bytes = cola::bytes_of(text);
  return device.receive({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, now);
}

std::vector<double> two_metres(std::span<const Beam> beams) {
  std::vector<double> ranges(beams.size(), 2.0);
  ranges[0] = std::numeric_limits<double>::quiet_NaN();
  return ranges;
}

/// The scan between STX and ETX.
std::optional<cola::ScanData> scan_in(const std::string& bytes) {
  if (bytes.size() < 2) return std::nullopt;
  return cola::parse_scan(bytes.substr(1, bytes.size() - 2));
}

TEST(ColaDevice, SettingsNeedALogin) {
  ColaDevice device{lms111(), Time{}};
  EXPECT_EQ(send(device, "sWN LMDscandatacfg 01 00 1 0 0 00 00 0 0 0 0 +1"), cola::bytes_of("sFA 1"));
  EXPECT_EQ(send(device, "sMN SetAccessMode 03 12345678"), cola::bytes_of("sAN SetAccessMode 0"));
  EXPECT_EQ(send(device, "sMN SetAccessMode 03 F4724744"), cola::bytes_of("sAN SetAccessMode 1"));
  EXPECT_EQ(send(device, "sWN LMDscandatacfg 01 00 1 0 0 00 00 0 0 0 0 +1"), cola::bytes_of("sWA LMDscandatacfg"));
  EXPECT_EQ(send(device, "sMN Run"), cola::bytes_of("sAN Run 1"));
  EXPECT_EQ(send(device, "sMN LMCstartmeas"), cola::bytes_of("sFA 1")) << "Run leaves the login";
}

TEST(ColaDevice, StreamsWhileSubscribed) {
  ColaDevice device{lms111(), Time{}};
  EXPECT_FALSE(device.is_measuring());
  EXPECT_EQ(send(device, "sEN LMDscandata 1"), cola::bytes_of("sEA LMDscandata 1"));
  const auto scan = scan_in(device.end_turn(Time{} + std::chrono::milliseconds{20}, two_metres));
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->scan_time_us, 20'000u);
  EXPECT_EQ(scan->send_time_us, 40'000u);
  ASSERT_EQ(scan->channels.size(), 1u);
  ASSERT_EQ(scan->channels[0].values.size(), 541u);
  EXPECT_EQ(scan->channels[0].values[0], 0);
  EXPECT_EQ(scan->channels[0].values[540], 2000);
  EXPECT_EQ(send(device, "sEN LMDscandata 0"), cola::bytes_of("sEA LMDscandata 0"));
  EXPECT_FALSE(device.is_measuring());
}

TEST(ColaDevice, GivesOneScanWhenItIsRead) {
  ColaDevice device{tim561(), Time{}};
  EXPECT_EQ(send(device, "sRN LMDscandata"), "");
  const std::string bytes = device.end_turn(Time{}, two_metres);
  EXPECT_EQ(bytes.substr(1, 3), "sRA");
  EXPECT_EQ(scan_in(bytes)->channels[0].values.size(), 811u);
  EXPECT_FALSE(device.is_measuring());
}

TEST(ColaDevice, AnLmsAndATimTellDifferentStates) {
  ColaDevice lms{lms111(), Time{}};
  EXPECT_EQ(send(lms, "sRN STlms").substr(1, 11), "sRA STlms 7");
  EXPECT_EQ(send(lms, "sRN SCdevicestate"), cola::bytes_of("sFA 3"));
  ColaDevice tim{tim561(), Time{}};
  EXPECT_EQ(send(tim, "sRN STlms"), cola::bytes_of("sFA 3"));
  EXPECT_EQ(send(tim, "sRN SCdevicestate"), cola::bytes_of("sRA SCdevicestate 1"));
}

TEST(ColaDevice, IsNotReadyWhileItWarmsUp) {
  ColaOptions options = lms111();
  options.warm_up = from_seconds(30.0);
  ColaDevice device{options, Time{}};
  EXPECT_EQ(send(device, "sRN STlms").substr(1, 11), "sRA STlms 1");
  (void)send(device, "sEN LMDscandata 1");
  EXPECT_EQ(device.end_turn(Time{}, two_metres), "");
  EXPECT_EQ(send(device, "sRN STlms", Time{} + from_seconds(31.0)).substr(1, 11), "sRA STlms 7");
  EXPECT_NE(device.end_turn(Time{} + from_seconds(31.0), two_metres), "");
}

}  // namespace
}  // namespace tandem::simulator
