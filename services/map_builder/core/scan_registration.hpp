#pragma once

#include <Eigen/Core>

#include "services/common/pose2.hpp"
#include "services/map_builder/core/surface_index.hpp"

namespace tandem {

/// How a scan is laid onto a surface.
struct RegistrationOptions {
  double first_reach_m = 0.4;  ///< A point is paired with the nearest one within this at first ...
  double last_reach_m = 0.15;  ///< ... and within this at last.
  double loss_m = 0.05;        ///< Pairs further apart than this count less and less (Cauchy).
  double deviation_m = 0.03;   ///< Spread of points across a surface.
  double point_weight = 0.3;   ///< Neighbouring points err together: each counts as this much of one.
  int most_steps = 12;
  Eigen::Matrix3d prior = Eigen::Matrix3d::Zero();  ///< Information that the guess holds, in the scan's frame.
};

/// Where a scan lies on a surface.
struct Registration {
  Pose2 reference_from_scan;
  Eigen::Matrix3d information =
      Eigen::Matrix3d::Zero();  ///< of the pairs about it, in the scan's frame, prior left out
  double matched_share = 0.0;   ///< share of the scan's points near the surface, [0, 1]
  double spread_m = 0.0;        ///< how far the paired points are from the surface: root of the robust mean square
};

/// The pose near `guess` at which `scan` lies best on `reference`.
///
/// Each point is drawn to the line through the nearest point of the reference (Censi, ICRA 2008), both facing the same
/// way, so that the two sides of a wall stay apart; Gauss-Newton, robust, new pairs in each step.
[[nodiscard]] Registration registered(const SurfaceIndex& reference, const Surface& scan, const Pose2& guess,
                                      const RegistrationOptions& options);

/// The share of the points of `scan` that have one of `reference` within `reach_m`.
[[nodiscard]] double matched_share(const SurfaceIndex& reference, const Surface& scan, const Pose2& reference_from_scan,
                                   double reach_m);

}  // namespace tandem
