#include "services/localization/core/scan_agreement.hpp"

#include "services/mapping/core/ray_casting.hpp"

namespace tandem {
namespace {

/// A beam may enter this much of a wall: it is thick, and a beam along it is a little off.
constexpr double kIntoWallM = 0.5;

}  // namespace

double agreement_of(const OccupancyGrid& map, const DistanceField& distances, const Pose2& map_from_base,
                    const Eigen::Vector2d& laser_in_base, std::span<const Eigen::Vector2d> endpoints_in_base,
                    double fit_distance_m) {
  if (endpoints_in_base.empty()) return 0.0;
  const Eigen::Vector2d laser_in_map = map_from_base * laser_in_base;
  std::size_t fitting = 0;
  for (const Eigen::Vector2d& endpoint : endpoints_in_base) {
    const Eigen::Vector2d end_in_map = map_from_base * endpoint;
    if (!distances.contains(end_in_map) || distances.nearest(end_in_map) > fit_distance_m) continue;
    const Eigen::Vector2d beam = end_in_map - laser_in_map;
    const double range_m = beam.norm();
    if (range_m > kIntoWallM) {
      const double seen_share = (range_m - kIntoWallM) / range_m;
      if (!line_of_sight(map, laser_in_map, laser_in_map + seen_share * beam)) continue;
    }
    ++fitting;
  }
  return static_cast<double>(fitting) / static_cast<double>(endpoints_in_base.size());
}

}  // namespace tandem
