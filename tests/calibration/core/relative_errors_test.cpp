#include "calibration/core/relative_errors.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

Time at(double seconds) {
  return Time{from_seconds(seconds)};
}

/// 20 m straight at 1 m/s; the wheels report `share` of it.
OdometryTrack odometry_with(double share) {
  std::vector<OdometrySample> samples;
  for (int i = 0; i <= 20; ++i) samples.push_back({at(i), {share * i, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0});
  return OdometryTrack{std::move(samples)};
}

std::vector<TimedPose> truth() {
  std::vector<TimedPose> poses;
  for (int i = 0; i <= 20; ++i) poses.push_back({at(i), {static_cast<double>(i), 0.0, 0.0}});
  return poses;
}

TEST(RelativeErrors, AreWhatTheWheelsMissOnTheWay) {
  const RelativeErrors errors = relative_errors_of(odometry_with(0.9), {}, truth(), 5.0, {});
  EXPECT_EQ(errors.stretches, 16u);  // from 0, 1, ..., 15
  EXPECT_NEAR(errors.median_m, 0.5, 1e-9);
  EXPECT_NEAR(errors.median_deg, 0.0, 1e-9);
}

TEST(RelativeErrors, AreNoneWithTheRightWheels) {
  const WheelUse use{.wheels = {.left_wheel_scale = 1.0 / 0.9, .right_wheel_scale = 1.0 / 0.9}};
  EXPECT_NEAR(relative_errors_of(odometry_with(0.9), use, truth(), 5.0, {}).median_m, 0.0, 1e-9);
}

TEST(RelativeErrors, LeaveOutStretchesThatTouchAWindow) {
  EXPECT_EQ(relative_errors_of(odometry_with(0.9), {}, truth(), 5.0, {{7.5, 7.6}}).stretches, 11u);  // not 3 to 7
}

}  // namespace
}  // namespace tandem
