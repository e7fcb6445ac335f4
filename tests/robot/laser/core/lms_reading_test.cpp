#include "robot/laser/core/lms_reading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tandem {
namespace {

constexpr double kQuarterTurn = std::numbers::pi / 2.0;

TEST(LmsReading, GoesFromTheRightToTheLeft) {
  const lms::ScanData scan{.values = std::vector<std::uint16_t>(181, 2000)};
  const DeviceScan out = device_scan_of(scan, {180, 100}, {}, 0, 80.0);
  EXPECT_DOUBLE_EQ(out.reading.angle_min_rad, -kQuarterTurn);
  EXPECT_NEAR(out.reading.angle_min_rad + 180 * out.reading.angle_increment_rad, kQuarterTurn, 1e-12);
  EXPECT_EQ(out.reading.ranges_m, std::vector<float>(181, 2.0f));
  EXPECT_TRUE(out.reading.intensities.empty());
}

TEST(LmsReading, MeansTheUnitThatTheScanSays) {
  const lms::ScanData scan{.millimetres = false, .values = {2000}};
  EXPECT_EQ(device_scan_of(scan, {180, 100}, {}, 0, 80.0).reading.ranges_m[0], 20.0f);
}

TEST(LmsReading, TakesCodesAtTheTopForNoReturn) {
  const lms::ScanData scan{.values = {8182, 8183, 8186, 8187, 8189, 8190, 8191, 0}};
  const auto ranges = device_scan_of(scan, {180, 100}, {}, 0, 80.0).reading.ranges_m;
  EXPECT_EQ(ranges[0], 8.182f);
  for (std::size_t i = 1; i < ranges.size(); ++i) EXPECT_TRUE(std::isnan(ranges[i])) << i;
}

TEST(LmsReading, LeavesTheFlagsAwayOrTakesThemForTheStrength) {
  const lms::ScanData scan{.values = {0x6000 | 1000}};
  const auto plain = device_scan_of(scan, {180, 100}, {.measuring_mode = 0}, 0, 80.0).reading;
  EXPECT_EQ(plain.ranges_m[0], 1.0f);
  EXPECT_TRUE(plain.intensities.empty());
  const auto with_strength = device_scan_of(scan, {180, 100}, {.measuring_mode = 1}, 0, 80.0).reading;
  EXPECT_EQ(with_strength.ranges_m[0], 1.0f);
  EXPECT_EQ(with_strength.intensities, std::vector<float>{3.0f});
}

TEST(LmsReading, CountsTheTimeOnTheLineAndInTheMirror) {
  const lms::ScanData scan{.values = std::vector<std::uint16_t>(361, 1000)};
  const DeviceScan out = device_scan_of(scan, {180, 50}, {}, 38'400, 80.0);
  EXPECT_NEAR(to_seconds(out.least_delay), 732 * 10 / 38'400.0, 1e-9);  // 10 bits a byte
  EXPECT_NEAR(out.period_s, 732 * 10 / 38'400.0, 1e-9);
  EXPECT_NEAR(to_seconds(out.mark_to_first_beam), -1.0 / 75.0, 1e-9);  // half a turn, and half of the second turn
  const DeviceScan at_once = device_scan_of(scan, {180, 50}, {}, 0, 80.0);
  EXPECT_EQ(at_once.least_delay, Duration::zero());
  EXPECT_NEAR(at_once.period_s, 2.0 / 75.0, 1e-9);
}

}  // namespace
}  // namespace tandem
