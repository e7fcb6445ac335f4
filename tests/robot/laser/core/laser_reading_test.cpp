#include "robot/laser/core/laser_reading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "robot/laser/core/cola_scan.hpp"
#include "robot/laser/core/lms_reading.hpp"
#include "robot/laser/core/scip_reading.hpp"

namespace tandem {
namespace {

constexpr double kRangeMax_m = 8.0;

/// The reading of each family's sensor: a return at 5 m, one beyond what counts, and a code that is no distance.
std::map<std::string, LaserReading> one_of_each_family() {
  scip::ScanData hokuyo{.request = {.first_step = 0, .last_step = 1080, .cluster = 1}};
  hokuyo.ranges_mm.assign(1081, 5000);
  hokuyo.ranges_mm[1] = 9000;
  hokuyo.ranges_mm[2] = 7;
  lms::ScanData sick{.values = std::vector<std::uint16_t>(361, 5000)};
  sick.values[1] = 8100;
  sick.values[2] = 8191;
  cola::ScanData cola{.frequency_centihz = 5000};
  cola.channels = {
      {.name = "DIST1", .start_angle = -450'000, .angle_step = 5000, .values = std::vector<std::uint16_t>(541, 5000)}};
  cola.channels[0].values[1] = 9000;
  cola.channels[0].values[2] = 0;
  return {{"scip", reading_of(hokuyo, scip::utm_30lx(), Time{}, kRangeMax_m)},
          {"lms2xx", device_scan_of(sick, {180, 50}, {}, 0, kRangeMax_m).reading},
          {"cola", cola::device_scan_of(cola, kRangeMax_m).value().reading}};
}

TEST(LaserReading, MeansTheSameOfEveryFamily) {
  for (const auto& [family, reading] : one_of_each_family()) {
    SCOPED_TRACE(family);
    const auto beams = static_cast<double>(reading.ranges_m.size());
    const double last_angle_rad = reading.angle_min_rad + (beams - 1.0) * reading.angle_increment_rad;
    EXPECT_GT(reading.angle_increment_rad, 0.0) << "counter-clockwise";
    EXPECT_NEAR(reading.angle_min_rad, -last_angle_rad, 1e-9) << "straight ahead is 0";
    EXPECT_GE(last_angle_rad, std::numbers::pi / 2.0 - 1e-9);

    EXPECT_FLOAT_EQ(reading.ranges_m[0], 5.0F) << "metres";
    EXPECT_TRUE(std::isnan(reading.ranges_m[1])) << "beyond what counts";
    EXPECT_TRUE(std::isnan(reading.ranges_m[2])) << "a code";
    EXPECT_DOUBLE_EQ(reading.range_max_m, kRangeMax_m);
    EXPECT_LT(reading.range_min_m, 0.1);
    EXPECT_TRUE(reading.intensities.empty());

    EXPECT_GT(reading.beam_interval_s, 0.0);
    const double share_of_turn = reading.angle_increment_rad / (2.0 * std::numbers::pi);
    EXPECT_NEAR(reading.beam_interval_s, share_of_turn * reading.scan_period_s, 1e-9);
  }
}

}  // namespace
}  // namespace tandem
