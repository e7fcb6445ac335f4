#include "bench/localization/simulated_drive.hpp"

#include <gtest/gtest.h>

#include "bench/localization/simulated_nees.hpp"

namespace tandem::bench {
namespace {

const DriveOptions kHall{.way_m = 15.0};
const DriveOptions kBlankCorridor{.way_m = 15.0, .corridor = true};

TEST(SimulatedDrive, IsTheSameForTheSameSeed) {
  const RecordedLog one = simulated_drive(5, kHall);
  const RecordedLog other = simulated_drive(5, kHall);

  ASSERT_EQ(one.truth.size(), other.truth.size());
  EXPECT_EQ(one.truth.back().map_from_base, other.truth.back().map_from_base);
  EXPECT_EQ(one.map, other.map);
}

TEST(SimulatedDrive, FindsTheLocalizerAsWrongAsItClaims) {
  const SimulatedErrors errors = simulated_errors(LocalizationConfig{}, kHall, 10);

  EXPECT_GT(errors.nees, 0.8);
  EXPECT_LT(errors.nees, 1.25);
}

TEST(SimulatedDrive, FindsTheLocalizerAsWrongAsItClaimsAlongABlankCorridor) {
  const SimulatedErrors errors = simulated_errors(LocalizationConfig{}, kBlankCorridor, 20);

  EXPECT_GT(errors.nees, 0.8);
  EXPECT_LT(errors.nees, 1.25);
  // The start and what the wheels err on the way: nothing else tells how far along it is.
  EXPECT_GT(errors.claimed_along_m, 0.1);
  EXPECT_LT(errors.claimed_across_m, 0.01);
}

}  // namespace
}  // namespace tandem::bench
