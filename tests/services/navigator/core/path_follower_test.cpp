#include "services/navigator/core/path_follower.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tandem::navigator {
namespace {

/// Ten metres ahead, then ten to the left.
PathFollower on_corner_path() {
  PathFollower follower{NavigatorConfig{}};
  follower.begin(Path{{{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}}}, {0.0, 0.0});
  return follower;
}

TEST(PathFollower, OnThePathItAimsStraightAhead) {
  PathFollower follower = on_corner_path();
  const Aim aim = follower.aim({1.0, 0.0, 0.0}, 0.5);

  EXPECT_NEAR(aim.way_m, 1.0, 1e-9);
  EXPECT_NEAR(aim.remaining_m, 19.0, 1e-9);
  EXPECT_NEAR(aim.curvature, 0.0, 1e-9);
  EXPECT_FALSE(aim.turn_in_place);
  EXPECT_FALSE(aim.arrived);
}

TEST(PathFollower, BesideThePathItAimsBackToIt) {
  PathFollower follower = on_corner_path();
  const Aim left_of_it = follower.aim({1.0, 0.1, 0.0}, 0.5);

  EXPECT_NEAR(left_of_it.cross_track_m, 0.1, 1e-9);
  EXPECT_LT(left_of_it.curvature, 0.0);  // to the right
}

TEST(PathFollower, TurnsInPlaceTowardsAPointFarAsideAndAimsTheShortWay) {
  PathFollower follower = on_corner_path();
  const Aim aim = follower.aim({1.0, 0.0, std::numbers::pi / 2.0}, 0.0);  // looks left, the path goes right

  EXPECT_TRUE(aim.turn_in_place);
  EXPECT_NEAR(aim.bearing_rad, -std::numbers::pi / 2.0, 1e-9);
}

TEST(PathFollower, GoesOnTurningInPlaceUntilItLooksAlongThePath) {
  const NavigatorConfig config;
  PathFollower follower = on_corner_path();
  EXPECT_TRUE(follower.aim({1.0, 0.0, -config.turn_in_place_from_rad - 0.05}, 0.0).turn_in_place);
  EXPECT_TRUE(follower.aim({1.0, 0.0, -config.turn_in_place_until_rad - 0.05}, 0.0).turn_in_place);
  EXPECT_FALSE(follower.aim({1.0, 0.0, -config.turn_in_place_until_rad + 0.05}, 0.0).turn_in_place);
  EXPECT_FALSE(follower.aim({1.0, 0.0, -config.turn_in_place_from_rad + 0.05}, 0.0).turn_in_place);
}

TEST(PathFollower, TheWayDoneNeverGoesBack) {
  PathFollower follower = on_corner_path();
  EXPECT_NEAR(follower.aim({1.0, 0.0, 0.0}, 0.5).way_m, 1.0, 1e-9);
  EXPECT_NEAR(follower.aim({0.2, 0.0, 0.0}, 0.5).way_m, 1.0, 1e-9);
}

TEST(PathFollower, ArrivesWithinTheTolerance) {
  PathFollower follower{NavigatorConfig{}};
  follower.begin(Path{{{0.0, 0.0}, {1.0, 0.0}}}, {0.0, 0.0});
  const double tolerance_m = NavigatorConfig{}.goal_tolerance_m;
  EXPECT_FALSE(follower.aim({1.0 - 1.1 * tolerance_m, 0.0, 0.0}, 0.5).arrived);
  EXPECT_TRUE(follower.aim({1.0 - 0.9 * tolerance_m, 0.0, 0.0}, 0.5).arrived);
}

}  // namespace
}  // namespace tandem::navigator
