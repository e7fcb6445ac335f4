#include "services/planner/core/motion/timed_path.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {

using Eigen::Vector2d;

double heading_towards(const Vector2d& from, const Vector2d& to) {
  return std::atan2(to.y() - from.y(), to.x() - from.x());
}

double turning_time_s(const Searcher& searcher, double from_rad, double to_rad) {
  if (searcher.field_of_view_rad >= 2.0 * std::numbers::pi) return 0.0;
  return std::abs(turn_between(from_rad, to_rad)) / searcher.turn_rate_radps;
}

TimedPath timed_path(const std::vector<Vector2d>& way, const Searcher& searcher, double initial_heading_rad) {
  TimedPath path;
  if (way.empty()) return path;
  double time_s = 0.0;
  double heading_rad = initial_heading_rad;
  path.points.push_back({time_s, way.front()});
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double length_m = (way[i] - way[i - 1]).norm();
    if (length_m < 1e-9) continue;
    const double next_rad = heading_towards(way[i - 1], way[i]);
    const double turn_s = turning_time_s(searcher, heading_rad, next_rad);
    if (turn_s > 0.0) {
      time_s += turn_s;
      path.points.push_back({time_s, way[i - 1]});
    }
    time_s += length_m / searcher.speed_mps;
    path.points.push_back({time_s, way[i]});
    heading_rad = next_rad;
  }
  return path;
}

Pose2 pose_at(const TimedPath& path, double time_s) {
  const auto& points = path.points;
  if (points.empty()) return {};
  const auto next = std::ranges::upper_bound(points, time_s, {}, &TimedPoint::time_s);
  const auto i = static_cast<std::size_t>(next - points.begin());
  // The heading of the piece walked now, or of the one before a stay.
  double heading_rad = 0.0;
  for (std::size_t k = std::min(i, points.size() - 1); k > 0; --k) {
    if ((points[k].point_in_map - points[k - 1].point_in_map).norm() < 1e-9) continue;
    heading_rad = heading_towards(points[k - 1].point_in_map, points[k].point_in_map);
    break;
  }
  if (i == 0) return {points.front().point_in_map.x(), points.front().point_in_map.y(), heading_rad};
  if (i == points.size()) return {points.back().point_in_map.x(), points.back().point_in_map.y(), heading_rad};
  const double share = (time_s - points[i - 1].time_s) / (points[i].time_s - points[i - 1].time_s);
  const Vector2d point = points[i - 1].point_in_map + share * (points[i].point_in_map - points[i - 1].point_in_map);
  return {point.x(), point.y(), heading_rad};
}

}  // namespace tandem
