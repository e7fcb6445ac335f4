#include "robot/laser/core/scip_reading.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "services/common/angle.hpp"

namespace tandem {
namespace {

/// Every third step of a UTM-30LX.
scip::ScanData scan_of(std::vector<std::uint32_t> ranges_mm) {
  ranges_mm.resize(361, 1000);
  return {.request = {.first_step = 0, .last_step = 1080, .cluster = 3, .skip = 3},
          .timestamp_ms = 0,
          .ranges_mm = std::move(ranges_mm),
          .intensities = {}};
}

TEST(ScipReading, TurnsErrorCodesAndNoEchoIntoNoReturn) {
  const LaserReading reading =
      reading_of(scan_of({0, 19, 22, 23, 5000, 30'000, 30'001, 60'001}), scip::utm_30lx(), {}, 30.0);
  for (const std::size_t none : {0, 1, 2, 6, 7}) EXPECT_TRUE(std::isnan(reading.ranges_m[none])) << none;
  EXPECT_FLOAT_EQ(reading.ranges_m[3], 0.023f);
  EXPECT_FLOAT_EQ(reading.ranges_m[4], 5.0f);
  EXPECT_FLOAT_EQ(reading.ranges_m[5], 30.0f);
  EXPECT_DOUBLE_EQ(reading.range_max_m, 30.0);
}

TEST(ScipReading, KeepsTheSensorsOwnLimitWhereThatIsLess) {
  EXPECT_DOUBLE_EQ(reading_of(scan_of({}), scip::urg_04lx(), {}, 30.0).range_max_m, 5.6);
}

TEST(ScipReading, PointsABeamOfThreeStepsToItsMiddle) {
  const LaserReading reading = reading_of(scan_of({}), scip::utm_30lx(), {}, 30.0);
  EXPECT_NEAR(reading.angle_increment_rad, from_degrees(0.75), 1e-12);
  EXPECT_NEAR(reading.angle_min_rad, from_degrees(-134.75), 1e-12);
  EXPECT_NEAR(reading.angle_min_rad + 180 * reading.angle_increment_rad, from_degrees(0.25), 1e-12);
}

TEST(ScipReading, TimesEachBeamWithinTheTurn) {
  scip::ScanData scan{.request = {.first_step = 720, .last_step = 1080, .cluster = 1},
                      .ranges_mm = std::vector<std::uint32_t>(361, 1000)};
  const LaserReading reading = reading_of(scan, scip::utm_30lx(), Time{}, 30.0);
  EXPECT_EQ(reading.first_beam, Time{} + std::chrono::microseconds{12'500});  // half of a turn of 25 ms
  EXPECT_NEAR(reading.beam_interval_s * 1440, 0.025, 1e-12);
}

}  // namespace
}  // namespace tandem
