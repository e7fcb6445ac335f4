#include "services/navigator/core/path.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace tandem::navigator {

Path::Path(const std::vector<Eigen::Vector2d>& points_in_map) {
  for (const auto& point : points_in_map) {
    const double step_m = points_.empty() ? 0.0 : (point - points_.back()).norm();
    if (!points_.empty() && step_m < 1e-3) continue;
    way_m_.push_back(points_.empty() ? 0.0 : way_m_.back() + step_m);
    points_.push_back(point);
  }
}

Eigen::Vector2d Path::point_at(double way_m) const {
  assert(!points_.empty());
  if (way_m <= 0.0) return points_.front();
  if (way_m >= length_m()) return points_.back();
  const auto next = std::upper_bound(way_m_.begin(), way_m_.end(), way_m);
  const auto i = static_cast<std::size_t>(next - way_m_.begin());
  const double share = (way_m - way_m_[i - 1]) / (way_m_[i] - way_m_[i - 1]);
  return points_[i - 1] + share * (points_[i] - points_[i - 1]);
}

Path::Place Path::nearest(const Eigen::Vector2d& point_in_map, double first_m, double last_m, double preference) const {
  assert(!points_.empty());
  first_m = std::clamp(first_m, 0.0, length_m());
  last_m = std::clamp(last_m, first_m, length_m());
  Place best{first_m, (point_at(first_m) - point_in_map).norm()};
  double best_cost = best.distance_m;
  for (std::size_t i = 1; i < points_.size(); ++i) {
    if (way_m_[i] < first_m || way_m_[i - 1] > last_m) continue;
    const double length = way_m_[i] - way_m_[i - 1];
    const Eigen::Vector2d along = (points_[i] - points_[i - 1]) / length;
    const double way = std::clamp(way_m_[i - 1] + along.dot(point_in_map - points_[i - 1]),
                                  std::max(first_m, way_m_[i - 1]), std::min(last_m, way_m_[i]));
    const double distance = (points_[i - 1] + (way - way_m_[i - 1]) * along - point_in_map).norm();
    const double cost = distance + preference * (way - first_m);
    if (cost < best_cost) {
      best = {way, distance};
      best_cost = cost;
    }
  }
  return best;
}

}  // namespace tandem::navigator
