#include "services/planner/core/srs/reward_ratio.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tandem {
namespace {

BoundaryVector at_distance(double distance) {
  return {distance, Eigen::Vector2d::UnitX()};
}

TEST(RewardRatio, HasTheSameReachInsideAndOutside) {
  const RewardRatio ramp{RatioShape::Ramp, 4.0, 0.0, 2.0, {}};
  EXPECT_DOUBLE_EQ(ratio_at(ramp, at_distance(0.0)), 4.0);
  EXPECT_DOUBLE_EQ(ratio_at(ramp, at_distance(0.5)), 3.0);
  EXPECT_DOUBLE_EQ(ratio_at(ramp, at_distance(-0.5)), 3.0);
  EXPECT_DOUBLE_EQ(ratio_at(ramp, at_distance(9.0)), 0.0);

  const RewardRatio fading{RatioShape::Exponential, 4.0, 1.0, 2.0, {}};
  EXPECT_DOUBLE_EQ(ratio_at(fading, at_distance(2.0)), 1.0 + 3.0 * std::exp(-1.0));
  EXPECT_DOUBLE_EQ(ratio_at(constant_ratio(-2.0), at_distance(7.0)), -2.0);
}

TEST(RewardRatio, MayDependOnTheDirection) {
  RewardRatio from_the_left = constant_ratio(2.0);
  from_the_left.towards_rad = std::numbers::pi / 2;
  EXPECT_NEAR(ratio_at(from_the_left, {1.0, {0, 1}}), 2.0, 1e-12);
  EXPECT_NEAR(ratio_at(from_the_left, {1.0, {1, 0}}), 1.0, 1e-12);
  EXPECT_NEAR(ratio_at(from_the_left, {1.0, {0, -1}}), 0.0, 1e-12);
  EXPECT_FALSE(is_constant(from_the_left));
}

TEST(RewardRatio, OneOfTwoSignsIsRefused) {
  EXPECT_TRUE(problem_of(RewardRatio{RatioShape::Ramp, 1.0, -1.0, 1.0, {}}));
  EXPECT_TRUE(problem_of(RewardRatio{RatioShape::Ramp, 1.0, 0.0, 0.0, {}}));
  EXPECT_FALSE(problem_of(RewardRatio{RatioShape::Ramp, 0.0, -1.0, 1.0, {}}));
  EXPECT_DOUBLE_EQ(peak_of(RewardRatio{RatioShape::Ramp, 0.0, -1.0, 1.0, {}}), -1.0);
}

TEST(RewardRatio, GradedWordsGrowByThree) {
  EXPECT_DOUBLE_EQ(*strength_per_s("quite"), 3.0 * *strength_per_s("a bit"));
  EXPECT_DOUBLE_EQ(*strength_per_s("very"), 3.0 * *strength_per_s("quite"));
  EXPECT_FALSE(strength_per_s("somewhat"));
}

}  // namespace
}  // namespace tandem
