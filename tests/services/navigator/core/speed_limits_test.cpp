#include "services/navigator/core/speed_limits.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tandem::navigator {
namespace {

const NavigatorConfig kConfig;

double limit(double curvature, double free_m, double remaining_m, std::vector<WalkingPerson> people = {}) {
  const Course course{.kind = Course::Kind::Arc, .curvature = curvature, .free = {free_m, {free_m, 0.0}}};
  Aim aim;
  aim.remaining_m = remaining_m;
  return speed_limit(kConfig, course, aim, Pose2{}, PoseQuality::Good, people);
}

TEST(SpeedLimits, FullSpeedWhereNothingSpeaksAgainstIt) {
  EXPECT_DOUBLE_EQ(limit(0.0, 100.0, 100.0), 0.5);
}

TEST(SpeedLimits, SlowsInCurvesBeforeTheGoalAndInNarrowViews) {
  EXPECT_LE(limit(2.0, 100.0, 100.0) * 2.0, kConfig.max_turn_rate_radps + 1e-12);
  EXPECT_DOUBLE_EQ(limit(0.0, 100.0, 0.08), 0.2);  // sqrt(2 x 0.25 x 0.08)
  EXPECT_DOUBLE_EQ(limit(0.0, 1.4, 100.0), 0.3);   // free view below 1.5 m
  EXPECT_DOUBLE_EQ(limit(0.0, 0.25, 100.0), 0.0);  // what is free is the margin
}

TEST(SpeedLimits, LeavesMoreMarginThanTheSafetyGateDoes) {
  for (double free_m = 0.0; free_m < 2.0; free_m += 0.01) {
    const double gate = speed_that_stops_within(free_m - 0.15, 0.5, 0.6);
    EXPECT_LE(limit(0.0, free_m, 100.0), gate) << free_m;
  }
}

TEST(SpeedLimits, ComesUpSlowlyToAPersonFromBehind) {
  const WalkingPerson away{{2.0, 0.0}, {0.6, 0.0}};
  const WalkingPerson towards{{2.0, 0.0}, {-0.6, 0.0}};
  const WalkingPerson aside{{0.0, 2.0}, {0.6, 0.0}};
  EXPECT_DOUBLE_EQ(limit(0.0, 100.0, 100.0, {away}), 0.3);
  EXPECT_DOUBLE_EQ(limit(0.0, 100.0, 100.0, {towards}), 0.5);  // sees the robot; the gate keeps the distance
  EXPECT_DOUBLE_EQ(limit(0.0, 100.0, 100.0, {aside}), 0.5);
}

TEST(SpeedLimits, AccelerationKeepsTheArcAndSlowingDownIsImmediate) {
  const Twist2 up = limited_acceleration(kConfig, {}, {0.5, 0.0, 0.5}, 0.0);
  EXPECT_DOUBLE_EQ(up.forward_mps, 0.015);  // 0.3 m/s^2 for 50 ms
  EXPECT_DOUBLE_EQ(up.turn_rate_radps, 0.015);
  EXPECT_EQ(limited_acceleration(kConfig, {0.5, 0.0, 0.0}, {}, 0.5), Twist2{});
  const Twist2 held = limited_acceleration(kConfig, {0.5, 0.0, 0.0}, {0.5, 0.0, 0.0}, 0.0);
  EXPECT_DOUBLE_EQ(held.forward_mps, 0.25);  // wheels that do not follow: the command does not run away
}

}  // namespace
}  // namespace tandem::navigator
