#include "services/localization/core/window_residuals.hpp"

#include <gtest/gtest.h>

#include <array>

#include "services/common/random.hpp"

namespace tandem {
namespace {

/// Checks the derivative by the block `which` of a residual of three values against differences.
void expect_derivatives_as_differences(const ceres::CostFunction& residual, std::vector<Eigen::Vector3d> poses,
                                       std::size_t which) {
  using Jacobian = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  std::vector<const double*> parameters;
  for (const Eigen::Vector3d& pose : poses) parameters.push_back(pose.data());
  Jacobian jacobian;
  std::array<double*, 2> jacobians{};
  jacobians[which] = jacobian.data();
  Eigen::Vector3d value;
  ASSERT_TRUE(residual.Evaluate(parameters.data(), value.data(), jacobians.data()));
  constexpr double kStep = 1e-6;
  for (int k = 0; k < 3; ++k) {
    Eigen::Vector3d low;
    Eigen::Vector3d high;
    poses[which][k] -= kStep;
    residual.Evaluate(parameters.data(), low.data(), nullptr);
    poses[which][k] += 2.0 * kStep;
    residual.Evaluate(parameters.data(), high.data(), nullptr);
    poses[which][k] -= kStep;
    EXPECT_LT((jacobian.col(k) - (high - low) / (2.0 * kStep)).norm(), 1e-6) << "block " << which << " column " << k;
  }
}

TEST(RelativePoseResidual, IsZeroWhereTheRobotDroveAsTheWheelsSay) {
  const RelativePoseResidual residual{{2.0, 0.0, 0.5}, Eigen::Vector3d{10.0, 10.0, 10.0}.asDiagonal().toDenseMatrix()};
  const Eigen::Vector3d before{1.0, 1.0, 0.0};
  const Eigen::Vector3d after{3.0, 1.0, 0.5};
  const double* parameters[] = {before.data(), after.data()};
  Eigen::Vector3d value;
  residual.Evaluate(parameters, value.data(), nullptr);

  EXPECT_LT(value.norm(), 1e-12);
}

TEST(RelativePoseResidual, CountsInDeviations) {
  const RelativePoseResidual residual{{2.0, 0.0, 0.0}, Eigen::Vector3d{10.0, 20.0, 1.0}.asDiagonal().toDenseMatrix()};
  const Eigen::Vector3d before{0.0, 0.0, 0.0};
  const Eigen::Vector3d after{2.1, 0.1, 0.0};
  const double* parameters[] = {before.data(), after.data()};
  Eigen::Vector3d value;
  residual.Evaluate(parameters, value.data(), nullptr);

  EXPECT_NEAR(value.x(), 1.0, 1e-9);  // 0.1 m of a deviation of 0.1 m
  EXPECT_NEAR(value.y(), 2.0, 1e-9);
}

TEST(RelativePoseResidual, HasTheDerivativesThatDifferencesHave) {
  Rng rng{21};
  for (int i = 0; i < 100; ++i) {
    const auto pose = [&] { return Eigen::Vector3d{rng.uniform(-5, 5), rng.uniform(-5, 5), rng.uniform(-1.5, 1.5)}; };
    const RelativePoseResidual residual{{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-0.1, 0.1)},
                                        Eigen::Vector3d{3.0, 5.0, 7.0}.asDiagonal().toDenseMatrix()};
    const std::vector<Eigen::Vector3d> poses{pose(), pose()};
    expect_derivatives_as_differences(residual, poses, 0);
    expect_derivatives_as_differences(residual, poses, 1);
  }
}

TEST(MarginalResidual, HasTheDerivativesThatDifferencesHave) {
  Rng rng{22};
  for (int i = 0; i < 100; ++i) {
    Eigen::Matrix3d root;
    for (double& value : root.reshaped()) value = rng.uniform(-3, 3);
    const MarginalResidual residual{{rng.uniform(-5, 5), rng.uniform(-5, 5), rng.uniform(-1.5, 1.5)}, root};
    expect_derivatives_as_differences(residual, {{rng.uniform(-5, 5), rng.uniform(-5, 5), rng.uniform(-1.5, 1.5)}}, 0);
  }
}

}  // namespace
}  // namespace tandem
