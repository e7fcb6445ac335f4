#include "robot/safety/core/swept_path.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "services/common/pose2.hpp"
#include "services/common/random.hpp"

namespace tandem::safety {
namespace {

constexpr Hull kHull{.half_length_m = 0.5, .half_width_m = 0.25};

TEST(SweptPath, StraightAheadCountsOnlyWhatIsInTheLane) {
  EXPECT_DOUBLE_EQ(time_to_contact(kHull, 0.0, {0.5, 0.0}, Eigen::Vector2d{2.5, 0.2}), 4.0);  // 2 m at 0.5 m/s
  EXPECT_TRUE(std::isinf(time_to_contact(kHull, 0.0, {0.5, 0.0}, Eigen::Vector2d{2.5, 0.26})));
  EXPECT_TRUE(std::isinf(time_to_contact(kHull, 0.0, {0.5, 0.0}, Eigen::Vector2d{-2.5, 0.0})));
  EXPECT_DOUBLE_EQ(time_to_contact(kHull, 0.0, {-0.5, 0.0}, Eigen::Vector2d{-2.5, 0.0}), 4.0);
}

TEST(SweptPath, ATurnInPlaceTouchesWhatTheCornersReach) {
  // Corners at 0.559 m: a point at 0.55 m beside the hull is met, one at 0.57 m is not.
  const Motion turn{0.0, 1.0};
  EXPECT_TRUE(std::isfinite(time_to_contact(kHull, 0.0, turn, Eigen::Vector2d{0.0, 0.55})));
  EXPECT_TRUE(std::isinf(time_to_contact(kHull, 0.0, turn, Eigen::Vector2d{0.0, 0.57})));
}

TEST(SweptPath, IsSymmetricToTheLeftAndToTheRight) {
  Rng rng{3};
  for (int i = 0; i < 1000; ++i) {
    const Motion motion{rng.uniform(-0.7, 0.7), rng.uniform(-1.0, 1.0)};
    const Eigen::Vector2d point{rng.uniform(-3, 3), rng.uniform(-3, 3)};
    const double left = time_to_contact(kHull, 0.02, motion, point);
    const double right = time_to_contact(kHull, 0.02, {motion.forward_mps, -motion.turn_rate_radps},
                                         Eigen::Vector2d{point.x(), -point.y()});
    if (std::isinf(left)) {
      EXPECT_TRUE(std::isinf(right));
    } else {
      EXPECT_NEAR(left, right, 1e-9);
    }
  }
}

TEST(SweptPath, AgreesWithDrivingTheArcInSmallSteps) {
  Rng rng{4};
  for (int i = 0; i < 500; ++i) {
    SCOPED_TRACE(i);
    const Motion motion{rng.uniform(-0.7, 0.7), rng.uniform(-1.0, 1.0)};
    const Eigen::Vector2d point{rng.uniform(-2, 2), rng.uniform(-2, 2)};
    if (distance_to_hull(kHull, point) == 0.0) continue;
    double driven = std::numeric_limits<double>::infinity();
    constexpr double kStep_s = 0.002;
    for (double t = 0.0; t < 5.0; t += kStep_s) {
      const double angle = motion.turn_rate_radps * t;
      const double radius = motion.forward_mps / motion.turn_rate_radps;
      const Pose2 start_from_base{radius * std::sin(angle), radius * (1.0 - std::cos(angle)), angle};
      if (distance_to_hull(kHull, inverse(start_from_base) * point) == 0.0) {
        driven = t;
        break;
      }
    }
    const double found = time_to_contact(kHull, 0.0, motion, point);
    if (std::isfinite(driven)) {
      EXPECT_NEAR(found, driven, 0.01);
    } else {
      EXPECT_GT(found, 4.99);
    }
  }
}

TEST(SweptPath, ARobotBesideAWallMayDriveOnAndAwayButNotCloser) {
  const Eigen::Vector2d beside{0.0, 0.26};  // 1 cm from the side, inside the margin of 2 cm
  EXPECT_TRUE(std::isinf(time_to_contact(kHull, 0.02, {0.3, 0.0}, beside)));
  const Eigen::Vector2d in_front{0.51, 0.0};
  EXPECT_DOUBLE_EQ(time_to_contact(kHull, 0.02, {0.3, 0.0}, in_front), 0.0);
  EXPECT_TRUE(std::isinf(time_to_contact(kHull, 0.02, {-0.3, 0.0}, in_front)));
}

TEST(SweptPath, NothingInsideTheHullIsAllowed) {
  EXPECT_DOUBLE_EQ(time_to_contact(kHull, 0.0, {-0.1, 0.0}, Eigen::Vector2d{0.2, 0.0}), 0.0);
}

TEST(SpeedThatStopsWithin, IsTheInverseOfTheStoppingDistance) {
  // 0.5 m/s: 0.25 m of reaction, 0.2083 m of braking at 0.6 m/s^2, 0.15 m of margin.
  EXPECT_NEAR(speed_that_stops_within(0.25 + 0.25 / 1.2 + 0.15, 0.5, 0.6, 0.15), 0.5, 1e-9);
  EXPECT_DOUBLE_EQ(speed_that_stops_within(0.15, 0.5, 0.6, 0.15), 0.0);
  EXPECT_DOUBLE_EQ(speed_that_stops_within(-1.0, 0.5, 0.6, 0.15), 0.0);
}

TEST(SweptPath, WhoStandsTouchesNothing) {
  EXPECT_TRUE(std::isinf(time_to_contact(kHull, 0.0, {0.0, 0.0}, Eigen::Vector2d{2.5, 0.0})));
}

TEST(SweptPath, TheCentreOfTheTurnIsNeverReached) {
  EXPECT_TRUE(std::isinf(time_to_contact(kHull, 0.0, {0.5, 0.5}, Eigen::Vector2d{0.0, 1.0})));
}

}  // namespace
}  // namespace tandem::safety
