#pragma once

#include <Eigen/Core>
#include <span>

#include "services/common/pose2.hpp"
#include "services/mapping/core/distance_field.hpp"

namespace tandem {

/// How refine_pose weighs beams and prior.
struct RefinementOptions {
  double loss_m = 0.1;            ///< Beams further from a wall than this count less and less (Cauchy).
  double hit_deviation_m = 0.12;  ///< Spread of returns around a wall.
  double beam_weight = 0.25;      ///< Neighbouring beams err together: each counts as this much of one.
  double prior_deviation_m = 0.15;
  double prior_deviation_rad = 0.1;
};

struct RefinedPose {
  Pose2 map_from_base;
  Covariance3 covariance = Covariance3::Zero();
};

/// The pose near `prior` at which beams that end at `endpoints_in_base` [m] lie best on the walls of `field`.
///
/// Minimises the robust sum of squared distances plus the pull of the prior (Ceres, Levenberg-Marquardt). The
/// covariance is the inverse of the information of beams and prior; along a blank corridor it is that of the prior.
[[nodiscard]] RefinedPose refine_pose(const DistanceField& field, std::span<const Eigen::Vector2d> endpoints_in_base,
                                      const Pose2& prior, const RefinementOptions& options);

}  // namespace tandem
