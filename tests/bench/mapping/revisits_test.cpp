#include "bench/mapping/revisits.hpp"

#include <gtest/gtest.h>

namespace tandem::bench {
namespace {

/// 30 m there and back again, a pose each metre and second.
std::vector<TimedPose> there_and_back() {
  std::vector<TimedPose> way;
  for (int i = 0; i <= 60; ++i) way.push_back({Time{from_seconds(i)}, {i <= 30 ? 1.0 * i : 60.0 - i, 0.0, 0.0}});
  return way;
}

TEST(Revisits, AreWhereTheRobotCameBackAfterLong) {
  const auto revisits = revisits_of(there_and_back(), {.near_m = 0.5, .least_way_m = 40.0, .every_m = 5.0});
  ASSERT_EQ(revisits.size(), 3U);  // at 50, 55 and 60 m of way
  EXPECT_EQ(revisits[0].later.map_from_base.x, 10.0);
  EXPECT_EQ(revisits[0].earlier.map_from_base.x, 10.0);
  EXPECT_EQ(to_seconds(revisits[0].earlier.time.time_since_epoch()), 10.0);
}

TEST(Revisits, AreNotFarFromTheTruthWhenTheyAreEstimatedAsTheTruth) {
  const auto revisits = revisits_of(there_and_back(), {});
  for (const double error : revisit_errors_m(revisits, there_and_back())) EXPECT_NEAR(error, 0.0, 1e-9);
}

TEST(Revisits, TellHowFarTheEstimateDrifted) {
  auto drifted = there_and_back();
  for (std::size_t i = 0; i < drifted.size(); ++i) drifted[i].map_from_base.y += 0.01 * static_cast<double>(i);
  const auto revisits = revisits_of(there_and_back(), {.near_m = 0.5, .least_way_m = 60.0, .every_m = 5.0});
  const auto errors = revisit_errors_m(revisits, drifted);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NEAR(errors[0], 0.6, 1e-9);  // after 60 m
}

}  // namespace
}  // namespace tandem::bench
