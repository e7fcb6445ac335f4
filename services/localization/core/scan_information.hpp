#pragma once

#include <Eigen/Core>
#include <span>

#include "services/common/pose2.hpp"
#include "services/mapping/core/distance_field.hpp"

namespace tandem {

/// What a scan tells about the pose it was taken from.
struct ScanInformation {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< inverse covariance of (x, y, heading) in the map
  Eigen::Matrix3d by_map = Eigen::Matrix3d::Zero();       ///< covariance by a map whose walls are off by 1 m
  Eigen::Vector2d free_in_map = Eigen::Vector2d::Zero();  ///< direction of which it tells nothing; zero: there is none
  double deviation_m = 0.0;                               ///< how far the beams that fit end from a wall
};

/// The information of beams that end at `endpoints_in_base` [m] and met surfaces across `normals_in_base`, with the
/// base at `map_from_base`, where they fit the map best by distances with the robust loss log(1 + d^2 / c^2), c =
/// `loss_m`.
///
///   information = A B^-1 A,  A = sum of w^2 max(0, 1 - d^2 / c^2) j j^T,  B = sum of w^2 d^2 g g^T,
///   w = 1 / (1 + d^2 / c^2)
/// A is how sharply the scan tells the pose: j is how a beam's distance across its surface changes with the pose. The
/// surface is that of the scan: the steps of a map's cells would tell something along a blank wall. B is how hard each
/// beam really pulls, by the gradient g of its distance d: far beams that graze a wall hardly miss it, and things that
/// are not on the map pull too (Huber's sandwich covariance).
///
/// What the direction that is told least seems to be told by noise alone is taken off, so that along a corridor nothing
/// is known. That direction stays `free_before_in_map` where it is nearly that of the last scan: were it to waver,
/// scans together would seem to tell the way along.
[[nodiscard]] ScanInformation scan_information(const DistanceField& field,
                                               std::span<const Eigen::Vector2d> endpoints_in_base,
                                               std::span<const Eigen::Vector2d> normals_in_base,
                                               const Pose2& map_from_base, double loss_m,
                                               const Eigen::Vector2d& free_before_in_map = Eigen::Vector2d::Zero());

}  // namespace tandem
