#include "services/localization/core/pose_refinement.hpp"

#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <Eigen/LU>
#include <cmath>
#include <deque>

#include "services/localization/core/scan_residual.hpp"
#include "services/localization/core/solver_setup.hpp"

namespace tandem {
namespace {

/// Information of `residual` about the pose at `parameters`, weighted by `weight`.
Eigen::Matrix3d information_of(const ScanResidual& residual, const double* parameters, double loss_m) {
  double distance_m = 0.0;
  Eigen::RowVector3d jacobian;
  double* jacobian_data = jacobian.data();
  residual.Evaluate(&parameters, &distance_m, &jacobian_data);
  const double robust_weight = 1.0 / (1.0 + distance_m * distance_m / (loss_m * loss_m));  // Cauchy
  return robust_weight * jacobian.transpose() * jacobian;
}

}  // namespace

RefinedPose refine_pose(const DistanceField& field, std::span<const Eigen::Vector2d> endpoints_in_base,
                        const Pose2& prior, const RefinementOptions& options) {
  double parameters[3] = {prior.x, prior.y, prior.heading};
  std::deque<ScanResidual> beams;  // a cost function does not move
  for (const Eigen::Vector2d& endpoint : endpoints_in_base) beams.emplace_back(field, endpoint);

  // Distances stay in metres; the prior is scaled so that both are in units of the same deviation.
  const double per_beam = options.hit_deviation_m / std::sqrt(options.beam_weight);
  PriorResidual prior_residual{prior, per_beam / options.prior_deviation_m, per_beam / options.prior_deviation_rad};
  ceres::CauchyLoss loss{options.loss_m};

  ceres::Problem problem{borrowing_problem()};
  for (ScanResidual& beam : beams) problem.AddResidualBlock(&beam, &loss, parameters);
  problem.AddResidualBlock(&prior_residual, nullptr, parameters);

  ceres::Solver::Summary summary;
  ceres::Solve(small_dense_solver(12), &problem, &summary);

  Eigen::Matrix3d information =
      Eigen::Vector3d{std::pow(options.prior_deviation_m, -2), std::pow(options.prior_deviation_m, -2),
                      std::pow(options.prior_deviation_rad, -2)}
          .asDiagonal();
  for (const ScanResidual& beam : beams) {
    information += information_of(beam, parameters, options.loss_m) / (per_beam * per_beam);
  }
  return {{parameters[0], parameters[1], wrap_to_pi(parameters[2])}, information.inverse()};
}

}  // namespace tandem
