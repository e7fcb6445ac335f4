#include "calibration/core/robust_covariance.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace tandem {
namespace {

bool is_positive(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>{matrix, Eigen::EigenvaluesOnly}.eigenvalues()(0) > 0.0;
}

/// Weight of a block, rho', and its derivative by the square of the residual.
struct Weight {
  double first;
  double second;

  Weight(const WeighedResidual& residual, double loss)
      : first(1.0 / (1.0 + residual.value.squaredNorm() / (loss * loss))), second(-first * first / (loss * loss)) {}
};

Eigen::MatrixXd curvature_of(std::span<const WeighedResidual> residuals, double loss) {
  const Eigen::Index count = residuals.front().jacobian.cols();
  Eigen::MatrixXd curvature = Eigen::MatrixXd::Zero(count, count);
  for (const WeighedResidual& residual : residuals) {
    const Weight weight{residual, loss};
    const Eigen::VectorXd plain = residual.jacobian.transpose() * residual.value;
    curvature += weight.first * residual.jacobian.transpose() * residual.jacobian +
                 2.0 * weight.second * plain * plain.transpose();
  }
  return curvature;
}

}  // namespace

Eigen::MatrixXd robust_covariance(std::span<const WeighedResidual> residuals, double loss) {
  if (residuals.empty()) return {};
  const Eigen::MatrixXd inverse = curvature_of(residuals, loss).inverse();
  const Eigen::Index count = inverse.cols();
  Eigen::MatrixXd pulls = Eigen::MatrixXd::Zero(count, count);
  Eigen::MatrixXd shared = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd last = Eigen::VectorXd::Zero(count);
  for (const WeighedResidual& residual : residuals) {
    const double weight = Weight{residual, loss}.first;
    const Eigen::Index size = residual.value.size();
    // What a block would be off by, had it no say itself.
    const Eigen::MatrixXd left =
        Eigen::MatrixXd::Identity(size, size) - weight * residual.jacobian * inverse * residual.jacobian.transpose();
    const Eigen::VectorXd pull = weight * residual.jacobian.transpose() * left.partialPivLu().solve(residual.value);
    pulls += pull * pull.transpose();
    if (residual.follows_the_last) shared += pull * last.transpose() + last * pull.transpose();
    last = pull;
  }
  // Few blocks can make the shared part outweigh the rest: half of it then, as the lags' weights would have it.
  Eigen::MatrixXd all = pulls + shared;
  if (!is_positive(all)) all = pulls + 0.5 * shared;
  return inverse * all * inverse;
}

}  // namespace tandem
