#include "services/map_builder/core/local_map.hpp"

#include <algorithm>
#include <cmath>

#include "services/localization/core/beams.hpp"

namespace tandem {
namespace {

constexpr double kCellM = 0.1;         ///< of the field that is searched
constexpr double kFarFromWallM = 0.7;  ///< Further away all places are equally bad.
constexpr BeamModel kBeams{.hit_deviation_m = 0.15, .random_share = 0.15};
constexpr std::size_t kSearchedPoints = 90;

}  // namespace

Pose2 LocalMap::best_pose(const Surface& scan, const Pose2& centre, const SearchWindow& window) {
  if (!field_) field_ = field_of(grid(kCellM));
  return best_pose_in_window(*field_, points_of(scan, kSearchedPoints, reach_m_), centre, window);
}

OccupancyGrid LocalMap::grid(double resolution_m) const {
  const int side = std::max(1, static_cast<int>(std::ceil(2.0 * reach_m_ / resolution_m)));
  OccupancyGrid grid{
      side, side, resolution_m, {centre_in_map_.x() - reach_m_, centre_in_map_.y() - reach_m_, 0.0}, CellState::Free};
  for (const SurfacePoint& point : index_.surface()) {
    const CellIndex cell = grid.cell_at(point.point);
    if (grid.contains(cell)) grid.set(cell, CellState::Occupied);
  }
  return grid;
}

LikelihoodField LocalMap::field_of(const OccupancyGrid& grid) {
  return {grid, DistanceField{grid, kFarFromWallM}, kBeams};
}

std::vector<Eigen::Vector2d> points_of(const Surface& surface, std::size_t count, double reach_m) {
  std::vector<Eigen::Vector2d> points;
  for (const SurfacePoint& p : surface) {
    if (p.point.norm() < reach_m) points.push_back(p.point);
  }
  return thinned(points, count);
}

}  // namespace tandem
