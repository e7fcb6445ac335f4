#include "services/tracking/core/walk.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace tandem::tracking {
namespace {

struct Place {
  std::size_t piece = 0;  ///< From point `piece` to the next.
  double share = 0.0;     ///< Of the piece.
  double distance_m = std::numeric_limits<double>::infinity();
  Eigen::Vector2d point_in_map{0.0, 0.0};
};

Place nearest_place(const std::vector<Eigen::Vector2d>& path, const Eigen::Vector2d& point) {
  Place best;
  if (path.size() == 1) best = {0, 0.0, (path.front() - point).norm(), path.front()};
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Eigen::Vector2d piece = path[i + 1] - path[i];
    const double share = std::clamp(piece.dot(point - path[i]) / std::max(1e-12, piece.squaredNorm()), 0.0, 1.0);
    const Eigen::Vector2d on_path = path[i] + share * piece;
    const double distance = (on_path - point).norm();
    if (distance < best.distance_m) best = {i, share, distance, on_path};
  }
  return best;
}

}  // namespace

double distance_from_path(const std::vector<Eigen::Vector2d>& path_in_map, const Eigen::Vector2d& point_in_map) {
  return nearest_place(path_in_map, point_in_map).distance_m;
}

Walk walk_along(const std::vector<Eigen::Vector2d>& path_in_map, const Eigen::Vector2d& from_in_map, double walked_m) {
  assert(!path_in_map.empty());
  const Place start = nearest_place(path_in_map, from_in_map);
  const Eigen::Vector2d offset = from_in_map - start.point_in_map;
  double left_m = walked_m;
  Eigen::Vector2d at = start.point_in_map;
  for (std::size_t i = start.piece; i + 1 < path_in_map.size(); ++i) {
    const Eigen::Vector2d to_end = path_in_map[i + 1] - at;
    const double length = to_end.norm();
    if (length > left_m) return {at + left_m / length * to_end + offset, to_end / length};
    left_m -= length;
    at = path_in_map[i + 1];
  }
  return {at + offset, {0.0, 0.0}};
}

}  // namespace tandem::tracking
