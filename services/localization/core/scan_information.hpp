#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/mapping/core/distance_field.hpp"

namespace tandem {

/// Direction across the surface at each endpoint, in the base frame, by its neighbours in the scan; zero where there
/// are too few of them or they form no line. The endpoints are in the order of their beams.
[[nodiscard]] std::vector<Eigen::Vector2d> surface_normals(std::span<const Eigen::Vector2d> endpoints_in_base);

/// What a scan tells about the pose it was taken from.
struct ScanInformation {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< inverse covariance of (x, y, heading) in the map
  double deviation_m = 0.0;                               ///< how far the beams that fit end from a wall
};

/// The information of beams that end at `endpoints_in_base` [m] with the base at `map_from_base`.
///
/// Each beam tells about the direction across the surface it met (Censi, ICRA 2007), as exactly as all of them turn out
/// to fit the map; beams further than `loss_m` from a wall count less and less. The surface is that of the scan: the
/// steps of a map's cells would tell something along a blank wall. What the weakest direction seems to tell by noise
/// alone is taken off, so that along a corridor nothing is known.
[[nodiscard]] ScanInformation scan_information(const DistanceField& field,
                                               std::span<const Eigen::Vector2d> endpoints_in_base,
                                               std::span<const Eigen::Vector2d> normals_in_base,
                                               const Pose2& map_from_base, double loss_m);

}  // namespace tandem
