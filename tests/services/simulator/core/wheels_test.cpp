#include "services/simulator/core/wheels.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tandem::simulator {
namespace {

constexpr double kQuarterTurn = std::numbers::pi / 2.0;

TEST(Wheels, TurnLeftWithTheRightWheelFaster) {
  const WheelSpeeds wheels = wheels_of({.forward_mps = 0.5, .turn_rate_radps = 1.0}, 0.25);

  EXPECT_DOUBLE_EQ(wheels.left_mps, 0.25);
  EXPECT_DOUBLE_EQ(wheels.right_mps, 0.75);
  EXPECT_EQ(body_of(wheels, 0.25), (BodySpeed{0.5, 1.0}));
}

TEST(Wheels, AQuarterOfACircleOfOneMetreEndsOneMetreAheadAndAside) {
  const Pose2 motion = arc({.forward_mps = kQuarterTurn, .turn_rate_radps = kQuarterTurn}, 1.0);

  EXPECT_NEAR(motion.x, 1.0, 1e-12);
  EXPECT_NEAR(motion.y, 1.0, 1e-12);
  EXPECT_NEAR(motion.heading, kQuarterTurn, 1e-12);
}

TEST(Wheels, StraightIsTheLimitOfAnArc) {
  EXPECT_EQ(arc({.forward_mps = 2.0}, 0.5), (Pose2{1.0, 0.0, 0.0}));
}

TEST(Wheels, SpeedGrowsAndFallsNoFasterThanItsRamps) {
  EXPECT_DOUBLE_EQ(ramped(0.0, 1.0, 0.3, 0.6), 0.3);
  EXPECT_DOUBLE_EQ(ramped(0.9, 1.0, 0.3, 0.6), 1.0);
  EXPECT_DOUBLE_EQ(ramped(1.0, 0.0, 0.3, 0.6), 0.4);
  EXPECT_DOUBLE_EQ(ramped(0.4, -1.0, 0.3, 0.6), 0.0);  // stops before it turns round
  EXPECT_DOUBLE_EQ(ramped(0.0, -1.0, 0.3, 0.6), -0.3);
  EXPECT_DOUBLE_EQ(ramped(-1.0, -0.2, 0.3, 0.6), -0.4);
}

TEST(Wheels, SlipIsARandomWalkThatTheSeedRepeats) {
  const SlipModel slip{.distance_per_root_m = 0.1, .turn_per_root_rad = 0.0, .turn_per_root_m = 0.0};
  Rng rng{3};
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kTimes = 4000;
  for (int i = 0; i < kTimes; ++i) {
    const double error = slipped({4.0, 0.0, 0.0}, slip, rng).x - 4.0;
    sum += error;
    squares += error * error;
  }
  EXPECT_NEAR(sum / kTimes, 0.0, 0.01);
  EXPECT_NEAR(std::sqrt(squares / kTimes), 0.2, 0.01);  // 0.1 x sqrt(4 m)
  Rng one{5};
  Rng same{5};
  EXPECT_EQ(slipped({1.0, 0.0, 0.5}, SlipModel{}, one), slipped({1.0, 0.0, 0.5}, SlipModel{}, same));
}

TEST(Wheels, WhatStandsDoesNotSlip) {
  Rng rng{1};
  EXPECT_EQ(slipped(Pose2{}, SlipModel{}, rng), Pose2{});
}

}  // namespace
}  // namespace tandem::simulator
