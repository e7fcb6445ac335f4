#include "services/localization/core/pose_prediction.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tandem {
namespace {

constexpr MotionNoise kExact{};
constexpr Duration kHalfASecond = std::chrono::milliseconds{500};

OdometrySample odometry(double seconds, const Pose2& odom_from_base, int epoch = 0) {
  return {Time{from_seconds(seconds)}, odom_from_base, {}, epoch};
}

/// At (2, 1), looking along y, by a scan at 10 s.
OdometryResult at_ten() {
  OdometryResult last;
  last.odometry = odometry(10.0, {5.0, 5.0, 0.0});
  last.result.time = last.odometry.time;
  last.result.map_from_base = {2.0, 1.0, std::numbers::pi / 2.0};
  last.result.status = LocalizationStatus::Ok;
  last.result.agreement = 0.9;
  last.result.hypotheses = {{last.result.map_from_base, 1.0}};
  return last;
}

TEST(PosePrediction, GoesOnAsTheWheelsSay) {
  const auto pose = predicted(at_ten(), odometry(10.1, {5.3, 5.0, 0.0}), kExact, kHalfASecond);

  ASSERT_TRUE(pose);
  EXPECT_EQ(pose->time, Time{from_seconds(10.1)});
  EXPECT_NEAR(pose->map_from_base.x, 2.0, 1e-12);  // 0.3 m ahead is along y there
  EXPECT_NEAR(pose->map_from_base.y, 1.3, 1e-12);
  EXPECT_EQ(pose->hypotheses.front().map_from_base, pose->map_from_base);
  EXPECT_EQ(pose->status, LocalizationStatus::Ok);
  EXPECT_EQ(pose->agreement, 0.9);
}

TEST(PosePrediction, KeepsTheCovarianceOfARobotThatStandsStill) {
  OdometryResult last = at_ten();
  last.result.covariance.diagonal() << 0.01, 0.04, 0.02;

  const auto pose = predicted(last, odometry(10.1, {5.0, 5.0, 0.0}), {.forward_per_m = 0.1}, kHalfASecond);

  EXPECT_EQ(pose->covariance, last.result.covariance);
}

TEST(PosePrediction, AddsTheErrorsOfTheMotionAlongTheHeading) {
  const MotionNoise noise{.forward_per_m = 0.5, .sideways_per_m = 0.25};
  const auto pose = predicted(at_ten(), odometry(10.1, {7.0, 5.0, 0.0}), noise, kHalfASecond);

  EXPECT_NEAR(pose->covariance(0, 0), 0.25, 1e-12);  // sideways is along x: (0.25 x 2 m)^2
  EXPECT_NEAR(pose->covariance(1, 1), 1.0, 1e-12);   // forward is along y: (0.5 x 2 m)^2
}

TEST(PosePrediction, MovesSidewaysWhenTheHeadingWasWrong) {
  OdometryResult last = at_ten();
  last.result.covariance(2, 2) = 0.01;
  const auto pose = predicted(last, odometry(10.1, {7.0, 5.0, 0.0}), kExact, kHalfASecond);

  EXPECT_NEAR(pose->covariance(0, 0), 0.04, 1e-12);   // 0.1 rad over 2 m is 0.2 m
  EXPECT_NEAR(pose->covariance(0, 2), -0.02, 1e-12);  // too far left is towards -x
  EXPECT_NEAR(pose->covariance(1, 1), 0.0, 1e-12);
}

TEST(PosePrediction, SaysNothingWhereTheWheelsDoNotTell) {
  const Pose2 there{5.0, 5.0, 0.0};
  EXPECT_TRUE(predicted(at_ten(), odometry(10.5, there), kExact, kHalfASecond));
  EXPECT_FALSE(predicted(at_ten(), odometry(10.6, there), kExact, kHalfASecond));  // the laser has failed
  EXPECT_FALSE(predicted(at_ten(), odometry(9.9, there), kExact, kHalfASecond));   // too late
  EXPECT_FALSE(predicted(at_ten(), odometry(10.1, there, 1), kExact, kHalfASecond));
}

}  // namespace
}  // namespace tandem
