#include "robot/safety/core/speed_limits.hpp"

#include <gtest/gtest.h>

namespace tandem::safety {
namespace {

constexpr Hull kHull{};  // 0.626 m x 0.505 m
const GateConfig kConfig{};

BaseInput good_base() {
  BaseInput base;
  base.watchdog_s = 0.5;
  base.deceleration_mps2 = 0.6;
  return base;
}

TEST(SpeedLimits, FallInStepsWithTheDistanceToAPerson) {
  EXPECT_DOUBLE_EQ(speed_near_person(2.51, 0.5), 0.5);
  EXPECT_DOUBLE_EQ(speed_near_person(2.5, 0.5), 0.4);
  EXPECT_DOUBLE_EQ(speed_near_person(1.2, 0.5), 0.4);
  EXPECT_DOUBLE_EQ(speed_near_person(1.19, 0.5), 0.2);
  EXPECT_DOUBLE_EQ(speed_near_person(0.6, 0.5), 0.2);
  EXPECT_DOUBLE_EQ(speed_near_person(0.59, 0.5), 0.0);
}

TEST(SpeedLimits, MeasureFromTheHullNotFromTheCentre) {
  const Eigen::Vector2d ahead[] = {{0.313 + 2.0, 0.0}};
  EXPECT_DOUBLE_EQ(nearest_person_m(kHull, {ahead, 0.0}), 2.0);
  const Eigen::Vector2d beside[] = {{0.0, 0.2525 + 1.5}};
  EXPECT_DOUBLE_EQ(nearest_person_m(kHull, {beside, 0.0}), 1.5);
}

TEST(SpeedLimits, AreLowWhilePeopleAreUnknown) {
  EXPECT_DOUBLE_EQ(speed_limit_mps(kConfig, kHull, {{}, 0.5}, good_base()), 0.5);
  EXPECT_DOUBLE_EQ(speed_limit_mps(kConfig, kHull, {{}, 0.51}, good_base()), 0.3);
  EXPECT_DOUBLE_EQ(speed_limit_mps(kConfig, kHull, {{}, std::nullopt}, good_base()), 0.3);
}

TEST(SpeedLimits, AreLowWhileTheBrakesAreUnknown) {
  BaseInput slow_watchdog = good_base();
  slow_watchdog.watchdog_s = 2.0;
  BaseInput unknown_watchdog = good_base();
  unknown_watchdog.watchdog_s = 0.0;
  BaseInput weak_brakes = good_base();
  weak_brakes.deceleration_mps2 = 0.3;
  for (const BaseInput& base : {slow_watchdog, unknown_watchdog, weak_brakes}) {
    EXPECT_DOUBLE_EQ(speed_limit_mps(kConfig, kHull, {{}, 0.0}, base), 0.3);
  }
}

Motion limited(const Motion& wanted, const Eigen::Vector2d& point) {
  return limited_by_surroundings(kConfig, kHull, 0.6, 0.0, wanted, std::span{&point, 1}).motion;
}

TEST(LimitedBySurroundings, StopsInFrontOfAnObstacle) {
  EXPECT_NEAR(limited({0.5, 0.0}, {0.313 + 2.0, 0.0}).forward_mps, 0.5, 1e-9);
  EXPECT_NEAR(limited({0.5, 0.0}, {0.313 + 1.4, 0.0}).forward_mps, 0.3, 1e-9);  // SAF-3: less than 1.5 m of view
  EXPECT_DOUBLE_EQ(limited({0.5, 0.0}, {0.313 + 0.15, 0.0}).forward_mps, 0.0);
}

TEST(LimitedBySurroundings, KeepsTheShapeOfTheArc) {
  const Motion motion = limited({0.5, 0.25}, {0.9, 0.2});
  EXPECT_LT(motion.forward_mps, 0.5);
  EXPECT_GT(motion.forward_mps, 0.0);
  EXPECT_NEAR(motion.turn_rate_radps / motion.forward_mps, 0.5, 1e-9);
}

TEST(LimitedBySurroundings, TurnsInPlaceSlowlyNearThingsAndNotAtAllTooNear) {
  EXPECT_DOUBLE_EQ(limited({0.0, 1.0}, {2.0, 0.0}).turn_rate_radps, 1.0);
  EXPECT_DOUBLE_EQ(limited({0.0, 1.0}, {0.313 + 0.59, 0.0}).turn_rate_radps, 0.5);
  EXPECT_DOUBLE_EQ(limited({0.0, 1.0}, {0.0, 0.51}).turn_rate_radps, 0.5);  // 0.402 + 0.1 = 0.502 m
  EXPECT_DOUBLE_EQ(limited({0.0, 1.0}, {0.0, 0.49}).turn_rate_radps, 0.0);
}

TEST(LimitedBySurroundings, SlowsDownWhenTheScanIsLate) {
  const Eigen::Vector2d point{0.313 + 0.4, 0.0};
  const double fresh = limited({0.5, 0.0}, point).forward_mps;
  const double late =
      limited_by_surroundings(kConfig, kHull, 0.6, 0.2, {0.5, 0.0}, std::span{&point, 1}).motion.forward_mps;
  EXPECT_LT(late, fresh);
}

}  // namespace
}  // namespace tandem::safety
