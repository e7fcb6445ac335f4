#include "robot/laser/core/cola_scan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tandem::cola {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// A scan word by word: an LMS111 at 50 Hz, three beams from -45 deg on in steps of half a degree, strengths of 8 bits.
const std::string kText =
    "sSN LMDscandata 1 1 89A27F 0 0 343 347 27477BA9 2747813B 0 0 7 0 0 1388 168 0 1 DIST1 3F800000 00000000 FFF92230 "
    "1388 3 3E8 0 7D0 1 RSSI1 3F800000 00000000 FFF92230 1388 3 A 0 FF 0 0 0 0 0";

ScanData scan() {
  ScanData data{.telegram_count = 1, .scan_count = 2, .scan_time_us = 1000, .send_time_us = 31'000};
  data.frequency_centihz = 5000;
  data.channels = {{.name = "DIST1", .start_angle = -450'000, .angle_step = 5000, .values = {1000, 0, 2000, 5}}};
  return data;
}

TEST(ColaScan, IsReadWordByWord) {
  const auto data = parse_scan(kText);
  ASSERT_TRUE(data);
  EXPECT_EQ(data->status, 0);
  EXPECT_EQ(data->telegram_count, 0x343u);
  EXPECT_EQ(data->send_time_us - data->scan_time_us, 0x592u);
  EXPECT_EQ(data->frequency_centihz, 5000u);
  ASSERT_EQ(data->channels.size(), 2u);
  EXPECT_EQ(data->channels[0].start_angle, -450'000);
  EXPECT_EQ(data->channels[0].values, (std::vector<std::uint16_t>{1000, 0, 2000}));
  EXPECT_EQ(data->channels[1].values, (std::vector<std::uint16_t>{10, 0, 255}));
}

TEST(ColaScan, MayHaveEncodersBeforeAndTextWithSpacesBehindItsChannels) {
  std::string text = kText;
  text.replace(text.find("168 0 1 DIST1"), 7, "168 1 11 22 1");
  text += " 1 4 my laser in the cellar";
  const auto data = parse_scan(text);
  ASSERT_TRUE(data);
  EXPECT_EQ(data->channels[0].values.size(), 3u);
}

TEST(ColaScan, GoesThereAndBack) {
  ScanData data = scan();
  EXPECT_EQ(parse_scan(text_of(data, "sSN")), data);
  data.channels.push_back({.name = "RSSI1", .scale = 2.0f, .offset = 1.0f, .values = {1, 2, 3, 255}});
  EXPECT_EQ(parse_scan(text_of(data, "sRA")), data);
}

TEST(ColaScan, OneThatIsNotWholeIsNone) {  // fault S4
  const Words words = words_of(kText);
  std::string text;
  for (std::size_t i = 0; i < words.size() - 5; ++i) {  // the last five stand behind the channels
    EXPECT_FALSE(parse_scan(text)) << i;
    text += (i == 0 ? "" : " ") + words[i];
  }
  EXPECT_TRUE(parse_scan(text));
}

TEST(ColaScan, ClaimsBeyondReasonAreNone) {
  for (const auto& [from, to] : {std::pair{"168 0 1 DIST1", "168 0 FFFFFFFF DIST1"},
                                 {"1388 3 3E8", "1388 FFFFFFFF 3E8"},
                                 {"168 0 1", "168 FFFFFFFF 1"},
                                 {"3 3E8", "3 10000"},
                                 {"DIST1 3F800000", "DIST1 7F800000"}}) {
    std::string text = kText;
    text.replace(text.find(from), std::string_view{from}.size(), to);
    EXPECT_FALSE(parse_scan(text)) << to;
  }
}

TEST(ColaScan, NinetyDegreesIsStraightAhead) {
  const auto out = device_scan_of(scan(), 20.0);
  ASSERT_TRUE(out);
  EXPECT_NEAR(out->reading.angle_min_rad, -135.0 * kDegree, 1e-9);
  EXPECT_NEAR(out->reading.angle_increment_rad, 0.5 * kDegree, 1e-9);
  EXPECT_NEAR(out->reading.beam_interval_s, 0.02 / 720.0, 1e-12);
}

TEST(ColaScan, ZeroAndSmallValuesAreNoDistances) {
  const auto ranges = device_scan_of(scan(), 1.5)->reading.ranges_m;
  EXPECT_EQ(ranges[0], 1.0f);
  EXPECT_TRUE(std::isnan(ranges[1]));
  EXPECT_TRUE(std::isnan(ranges[2]));  // beyond 1.5 m
  EXPECT_TRUE(std::isnan(ranges[3]));
}

TEST(ColaScan, AValueIsScaled) {
  ScanData data = scan();
  data.channels[0].scale = 2.0f;
  data.channels[0].offset = 100.0f;
  EXPECT_FLOAT_EQ(device_scan_of(data, 20.0)->reading.ranges_m[0], 2.1f);
}

TEST(ColaScan, TakesStrengthsThatBelongToTheDistances) {
  EXPECT_EQ(device_scan_of(*parse_scan(kText), 20.0)->reading.intensities, (std::vector<float>{10, 0, 255}));
  ScanData data = scan();
  data.channels.push_back({.name = "RSSI1", .values = {1, 2}});
  EXPECT_TRUE(device_scan_of(data, 20.0)->reading.intensities.empty());
}

TEST(ColaScan, ItsClockSaysHowLongItWasKeptEvenWhenItWraps) {
  EXPECT_EQ(device_scan_of(scan(), 20.0)->mark_to_first_beam, -std::chrono::milliseconds{30});
  ScanData data = scan();
  data.scan_time_us = 0xFFFFFFFF - 9;
  data.send_time_us = 20;
  EXPECT_EQ(device_scan_of(data, 20.0)->mark_to_first_beam, -std::chrono::microseconds{30});
}

TEST(ColaScan, WithoutDistancesThereIsNoReading) {
  ScanData data = scan();
  data.channels[0].name = "DIST2";
  EXPECT_FALSE(device_scan_of(data, 20.0));
  data = scan();
  data.frequency_centihz = 0;
  EXPECT_FALSE(device_scan_of(data, 20.0));
  data = scan();
  data.channels[0].angle_step = 0;
  EXPECT_FALSE(device_scan_of(data, 20.0));
}

TEST(ColaScan, TheStatusTellsOfDirt) {
  EXPECT_EQ(complaint_of(0), "");
  EXPECT_NE(complaint_of(2).find("getting dirty"), std::string::npos);
  EXPECT_NE(complaint_of(4).find("dirty"), std::string::npos);
  EXPECT_NE(complaint_of(1).find("error"), std::string::npos);
}

}  // namespace
}  // namespace tandem::cola
