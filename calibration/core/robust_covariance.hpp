#pragma once

#include <Eigen/Core>
#include <span>

namespace tandem {

/// One block of residuals, in units of its deviations, with its derivatives at the solution.
struct WeighedResidual {
  Eigen::VectorXd value;
  Eigen::MatrixXd jacobian;
  bool follows_the_last = false;  ///< It shares a measurement with the block before.
};

/// Covariance of the parameters that minimise the sum of Cauchy's loss (scale `loss`) of the blocks.
///
/// H^-1 S H^-1 with the second derivative H of that sum, and S the sum of what the blocks pull, g g', and of g h' + h
/// g' for blocks g and h that share a measurement (Huber; Newey and West, cut after one lag, as errors reach no
/// further). So it is right whatever the deviations of the blocks were taken for; each block pulls as it would, had it
/// no say in the solution (MacKinnon and White: few blocks tell of some parameters). Not finite where a parameter has
/// no effect.
[[nodiscard]] Eigen::MatrixXd robust_covariance(std::span<const WeighedResidual> residuals, double loss);

}  // namespace tandem
