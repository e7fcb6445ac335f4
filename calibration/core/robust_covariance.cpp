#include "calibration/core/robust_covariance.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace tandem {
namespace {

bool is_positive(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>{matrix, Eigen::EigenvaluesOnly}.eigenvalues()(0) > 0.0;
}

}  // namespace

Eigen::MatrixXd robust_covariance(std::span<const WeighedResidual> residuals, double loss) {
  if (residuals.empty()) return {};
  const Eigen::Index count = residuals.front().jacobian.cols();
  Eigen::MatrixXd curvature = Eigen::MatrixXd::Zero(count, count);
  Eigen::MatrixXd pulls = Eigen::MatrixXd::Zero(count, count);
  Eigen::MatrixXd shared = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd last = Eigen::VectorXd::Zero(count);
  for (const WeighedResidual& residual : residuals) {
    const double first = 1.0 / (1.0 + residual.value.squaredNorm() / (loss * loss));  // rho', and rho'' is:
    const double second = -first * first / (loss * loss);
    const Eigen::VectorXd plain = residual.jacobian.transpose() * residual.value;
    curvature += first * residual.jacobian.transpose() * residual.jacobian + 2.0 * second * plain * plain.transpose();
    const Eigen::VectorXd pull = first * plain;
    pulls += pull * pull.transpose();
    if (residual.follows_the_last) shared += pull * last.transpose() + last * pull.transpose();
    last = pull;
  }
  const auto blocks = static_cast<double>(residuals.size() * static_cast<std::size_t>(residuals.front().value.size()));
  const double few = blocks / std::max(1.0, blocks - static_cast<double>(count));
  // Few blocks can make the shared part outweigh the rest: half of it then, as the lags' weights would have it.
  Eigen::MatrixXd all = pulls + shared;
  if (!is_positive(all)) all = pulls + 0.5 * shared;
  const Eigen::MatrixXd inverse = curvature.inverse();
  return few * inverse * all * inverse;
}

}  // namespace tandem
