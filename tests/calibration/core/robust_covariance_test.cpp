#include "calibration/core/robust_covariance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "services/common/random.hpp"

namespace tandem {
namespace {

WeighedResidual scalar(double value, bool follows_the_last = false) {
  return {.value = Eigen::VectorXd::Constant(1, value),
          .jacobian = Eigen::MatrixXd::Constant(1, 1, 1.0),
          .follows_the_last = follows_the_last};
}

constexpr double kNoLoss = 1e6;

TEST(RobustCovariance, OfAMeanIsTheVarianceOverTheCount) {
  // Whatever the deviations were taken for: +-2 about the mean, four times.
  const std::vector<WeighedResidual> residuals{scalar(2.0), scalar(-2.0), scalar(2.0), scalar(-2.0)};
  EXPECT_NEAR(robust_covariance(residuals, kNoLoss)(0, 0), 4.0 / 4.0 * (16.0 / 9.0), 1e-6);  // by three without one
}

TEST(RobustCovariance, KnowsThatSharedMeasurementsCancel) {
  // Differences of positions: their sum is known far better than if each erred on its own.
  Rng rng{7};
  std::vector<WeighedResidual> residuals;
  double last = rng.normal();
  for (int i = 0; i < 5000; ++i) {
    const double next = rng.normal();
    residuals.push_back(scalar(next - last, i > 0));
    last = next;
  }
  const double alone = 2.0 / 5000.0;
  EXPECT_LT(robust_covariance(residuals, kNoLoss)(0, 0), 0.51 * alone);
  for (WeighedResidual& residual : residuals) residual.follows_the_last = false;
  EXPECT_NEAR(robust_covariance(residuals, kNoLoss)(0, 0), alone, 0.1 * alone);
}

TEST(RobustCovariance, IsHardlyWidenedByAnOutlier) {
  Rng rng{3};
  std::vector<WeighedResidual> residuals;
  for (int i = 0; i < 1000; ++i) residuals.push_back(scalar(rng.normal()));
  const double clean = robust_covariance(residuals, 3.0)(0, 0);
  residuals.push_back(scalar(1000.0));
  EXPECT_NEAR(robust_covariance(residuals, 3.0)(0, 0), clean, 0.05 * clean);
  EXPECT_GT(robust_covariance(residuals, kNoLoss)(0, 0), 100.0 * clean);
}

TEST(RobustCovariance, IsNoNumberWhereAParameterHasNoEffect) {
  const Eigen::MatrixXd first_only = Eigen::RowVector2d{1.0, 0.0};
  const std::vector<WeighedResidual> residuals(5, {Eigen::VectorXd::Constant(1, 1.0), first_only});
  EXPECT_FALSE(robust_covariance(residuals, kNoLoss).allFinite());
}

}  // namespace
}  // namespace tandem
