#include "services/navigator/core/side_step.hpp"

#include <gtest/gtest.h>

namespace tandem::navigator {
namespace {

const Path kAhead{{{0.0, 0.0}, {10.0, 0.0}}};
const SideStepOptions kOptions{
    .half_width_m = 0.3, .hull_front_m = 0.3, .horizon_m = 3.0, .max_offset_m = 1.0, .lookahead_m = 1.0};

std::optional<SideStep> step_around(const std::vector<Eigen::Vector2d>& obstacles,
                                    const SideStepOptions& options = kOptions) {
  return side_step({.remaining_m = 10.0}, kAhead, {}, obstacles, options);
}

TEST(SideStep, WhereThePathIsFreeItStaysOnIt) {
  const auto step = step_around({});
  ASSERT_TRUE(step);
  EXPECT_NEAR(step->offset_m, 0.0, 1e-9);
  EXPECT_NEAR(step->point_in_base.x(), 1.0, 1e-9);
  EXPECT_NEAR(step->point_in_base.y(), 0.0, 1e-9);
}

TEST(SideStep, StepsToTheSideWhereTheSmallerShiftIsEnough) {
  const auto step = step_around({{2.0, -0.1}});  // a little to the right: pass it on the left
  ASSERT_TRUE(step);
  EXPECT_GT(step->offset_m, 0.0);
  EXPECT_LE(step->offset_m, 0.4);
  EXPECT_GT(step->point_in_base.y(), 0.0);
}

TEST(SideStep, MirroredObstaclesMirrorTheStep) {
  const auto left = step_around({{2.0, -0.15}, {2.2, -0.15}});
  const auto right = step_around({{2.0, 0.15}, {2.2, 0.15}});
  ASSERT_TRUE(left && right);
  EXPECT_NEAR(left->offset_m, -right->offset_m, 1e-9);
}

TEST(SideStep, ItDoesNotChangeSidesOnTheWay) {
  SideStepOptions options = kOptions;
  options.last_offset_m = -0.4;
  const auto step = step_around({{2.0, 0.0}}, options);
  ASSERT_TRUE(step);
  EXPECT_LT(step->offset_m, 0.0);
}

TEST(SideStep, ThereIsNoneAroundAWallAcrossTheWholeReach) {
  std::vector<Eigen::Vector2d> wall;
  for (double y = -2.0; y <= 2.0; y += 0.1) wall.emplace_back(2.0, y);
  EXPECT_FALSE(step_around(wall));
}

}  // namespace
}  // namespace tandem::navigator
