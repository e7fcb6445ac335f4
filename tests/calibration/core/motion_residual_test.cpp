#include "calibration/core/motion_residual.hpp"

#include <ceres/autodiff_cost_function.h>
#include <gtest/gtest.h>

#include <array>
#include <numbers>

namespace tandem {
namespace {

using Residual = ceres::AutoDiffCostFunction<MotionResidual, 3, 3, 3, 1>;
constexpr double kHalfTrackM = 0.2;

Eigen::Vector3d value_of(const MotionResidual& residual, const std::array<double, 7>& at) {
  Eigen::Vector3d value;
  residual(at.data(), at.data() + 3, at.data() + 6, value.data());
  return value;
}

WheelMotion straight_metre() {
  return {
      .steps = {{0.5, 0.0, 0.0}, {0.5, 0.0, 0.0}}, .rate_at_start = {0.5, 0.0, 0.0}, .rate_at_end = {0.5, 0.0, 0.0}};
}

TEST(MotionResidual, IsZeroWhereWheelsAndScansAgree) {
  const MotionResidual residual{straight_metre(), {1.0, 0.0, 0.0}, kHalfTrackM, Eigen::Matrix3d::Identity()};
  EXPECT_LT(value_of(residual, {1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0}).norm(), 1e-12);
}

TEST(MotionResidual, SaysByHowMuchLargerWheelsGoTooFar) {
  const MotionResidual residual{straight_metre(), {1.0, 0.0, 0.0}, kHalfTrackM, Eigen::Matrix3d::Identity()};
  EXPECT_NEAR(value_of(residual, {1.1, 1.1, 1.0, 0.0, 0.0, 0.0, 0.0}).x(), 0.1, 1e-12);
}

TEST(MotionResidual, SeesALaserThatLooksToTheLeftGoAsideWhenTheRobotGoesAhead) {
  // The scans say: 1 m to the right. So the laser is turned by a quarter to the left.
  const MotionResidual residual{straight_metre(), {0.0, -1.0, 0.0}, kHalfTrackM, Eigen::Matrix3d::Identity()};
  EXPECT_LT(value_of(residual, {1.0, 1.0, 1.0, 0.0, 0.0, std::numbers::pi / 2.0, 0.0}).norm(), 1e-12);
}

TEST(MotionResidual, MovesTheTimeOfTheWheels) {
  // From standing to 1 m/s: half a second later the robot is half a metre further.
  WheelMotion starting = straight_metre();
  starting.rate_at_start = {};
  starting.rate_at_end = {1.0, 0.0, 0.0};
  const MotionResidual residual{starting, {1.5, 0.0, 0.0}, kHalfTrackM, Eigen::Matrix3d::Identity()};
  EXPECT_LT(value_of(residual, {1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.5}).norm(), 1e-12);
}

TEST(MotionResidual, HasTheDerivativesOfItsDifferences) {
  const WheelMotion wheels{.steps = {{0.2, 0.0, 0.3}, {0.1, 0.0, -0.1}, {0.2, 0.0, 0.00001}},
                           .rate_at_start = {0.5, 0.0, 0.7},
                           .rate_at_end = {0.3, 0.0, -0.2}};
  Eigen::Matrix3d root;
  root << 3.0, 1.0, 0.5, 0.0, 2.0, 0.2, 0.0, 0.0, 4.0;
  const MotionResidual residual{wheels, {0.4, 0.1, 0.2}, kHalfTrackM, root};
  const Residual automatic{new MotionResidual{residual}};
  const std::array<double, 7> at{1.02, 0.97, 1.1, 0.1, -0.05, 0.2, 0.03};
  const std::array<const double*, 3> blocks{at.data(), at.data() + 3, at.data() + 6};
  Eigen::Vector3d value;
  Eigen::Matrix<double, 3, 3, Eigen::RowMajor> by_wheels;
  Eigen::Matrix<double, 3, 3, Eigen::RowMajor> by_laser;
  Eigen::Vector3d by_delay;
  std::array<double*, 3> jacobians{by_wheels.data(), by_laser.data(), by_delay.data()};
  ASSERT_TRUE(automatic.Evaluate(blocks.data(), value.data(), jacobians.data()));
  Eigen::Matrix<double, 3, 7> jacobian;
  jacobian << by_wheels, by_laser, by_delay;
  for (std::size_t i = 0; i < at.size(); ++i) {
    constexpr double kStep = 1e-6;
    auto more = at;
    auto less = at;
    more[i] += kStep;
    less[i] -= kStep;
    const Eigen::Vector3d difference = (value_of(residual, more) - value_of(residual, less)) / (2.0 * kStep);
    EXPECT_LT((jacobian.col(static_cast<Eigen::Index>(i)) - difference).norm(), 1e-6) << "parameter " << i;
  }
}

}  // namespace
}  // namespace tandem
