#include "services/localization/core/scan_information.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace tandem {
namespace {

constexpr double kNoiseShare = 0.03;        ///< of the strongest direction's sharpness: what noise seems to tell, ...
constexpr double kFreeNoiseShare = 0.09;    ///< ... at most, where the scan before told nothing
constexpr double kSameDirection = 0.995;    ///< cosine of 0.1 rad
constexpr double kLeastDeviationM = 0.005;  ///< No map is better than this.

/// How a distance with the gradient `across` changes with (x, y, heading), for an endpoint `arm` away from the base.
Eigen::Vector3d by_pose(const Eigen::Vector2d& across, const Eigen::Vector2d& arm) {
  return {across.x(), across.y(), across.y() * arm.x() - across.x() * arm.y()};
}

/// The sums over all beams; see scan_information.
struct Sums {
  Eigen::Matrix3d sharpness = Eigen::Matrix3d::Zero();  ///< A
  Eigen::Matrix3d pulls = Eigen::Matrix3d::Zero();      ///< B
  double weights = 0.0;
  double squares_m2 = 0.0;
};

Sums sums_of(const DistanceField& field, std::span<const Eigen::Vector2d> endpoints_in_base,
             std::span<const Eigen::Vector2d> normals_in_base, const Pose2& map_from_base, double loss_m) {
  Sums sums;
  const Pose2 turn{0.0, 0.0, map_from_base.heading};
  for (std::size_t i = 0; i < endpoints_in_base.size(); ++i) {
    const Eigen::Vector2d arm = turn * endpoints_in_base[i];
    const auto [distance_m, gradient] = field.smooth(map_from_base.position() + arm);
    const double square = distance_m * distance_m / (loss_m * loss_m);
    const double weight2 = 1.0 / ((1.0 + square) * (1.0 + square));
    const Eigen::Vector3d told = by_pose(turn * normals_in_base[i], arm);
    const Eigen::Vector3d pull = distance_m * by_pose(gradient, arm);
    sums.sharpness += weight2 * std::max(0.0, 1.0 - square) * told * told.transpose();
    sums.pulls += weight2 * (pull * pull.transpose() + kLeastDeviationM * kLeastDeviationM * told * told.transpose());
    sums.weights += weight2;
    sums.squares_m2 += weight2 * distance_m * distance_m;
  }
  return sums;
}

}  // namespace

ScanInformation scan_information(const DistanceField& field, std::span<const Eigen::Vector2d> endpoints_in_base,
                                 std::span<const Eigen::Vector2d> normals_in_base, const Pose2& map_from_base,
                                 double loss_m, const Eigen::Vector2d& free_before_in_map) {
  ScanInformation result;
  const Sums sums = sums_of(field, endpoints_in_base, normals_in_base, map_from_base, loss_m);
  if (sums.weights == 0.0) return result;
  result.deviation_m = std::max(kLeastDeviationM, std::sqrt(sums.squares_m2 / sums.weights));

  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
  axes.computeDirect(sums.sharpness.topLeftCorner<2, 2>());
  const double strongest = axes.eigenvalues()(1);
  const double weakest = axes.eigenvalues()(0);
  if (weakest <= 0.0) return result;
  Eigen::Vector2d weak = axes.eigenvectors().col(0);
  const bool was_free = std::abs(weak.dot(free_before_in_map)) > kSameDirection;
  if (was_free) weak = free_before_in_map;
  const double noise = (was_free ? kFreeNoiseShare : kNoiseShare) * strongest;
  const double kept = std::max(0.0, weakest - noise) / weakest;
  if (kept == 0.0) result.free_in_map = weak;

  // Along the weakest axis all is scaled, the heading's share too, so that the information stays that of some scan.
  Eigen::Matrix3d scale = Eigen::Matrix3d::Identity();
  scale.topLeftCorner<2, 2>() += (std::sqrt(kept) - 1.0) * weak * weak.transpose();
  result.information = scale * sums.sharpness * sums.pulls.inverse() * sums.sharpness * scale;

  // A map's error does not become less with scans from the same place; along a free direction it does nothing.
  const Eigen::Vector3d free{result.free_in_map.x(), result.free_in_map.y(), 0.0};
  const Eigen::Matrix3d seen = Eigen::Matrix3d::Identity() - free * free.transpose();
  const Eigen::Matrix3d mean = sums.sharpness / static_cast<double>(endpoints_in_base.size());
  result.by_map = seen * (mean + free * free.transpose()).inverse() * seen;
  return result;
}

}  // namespace tandem
