#include "bench/localization/simulated_drive.hpp"

#include <gtest/gtest.h>

#include "bench/localization/simulated_nees.hpp"

namespace tandem::bench {
namespace {

DriveOptions furnished_hall() {
  const LocalizationConfig config;
  DriveOptions options;
  options.way_m = 15.0;
  options.wheels =
      MotionNoise{config.forward_per_m, config.sideways_per_m, config.turn_per_rad, config.turn_per_m, 0.0, 0.0}.times(
          0.5);
  return options;
}

TEST(SimulatedDrive, IsTheSameForTheSameSeed) {
  const RecordedLog one = simulated_drive(5, furnished_hall());
  const RecordedLog other = simulated_drive(5, furnished_hall());

  ASSERT_EQ(one.truth.size(), other.truth.size());
  EXPECT_EQ(one.truth.back().map_from_base, other.truth.back().map_from_base);
  EXPECT_EQ(one.map, other.map);
}

TEST(SimulatedDrive, FindsTheLocalizerAsWrongAsItClaims) {
  const SimulatedErrors errors = simulated_errors(LocalizationConfig{}, furnished_hall(), 10);

  EXPECT_GT(errors.nees, 0.8);
  EXPECT_LT(errors.nees, 1.25);
}

}  // namespace
}  // namespace tandem::bench
