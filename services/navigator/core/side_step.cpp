#include "services/navigator/core/side_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tandem::navigator {
namespace {

constexpr double kStep = 0.1;  ///< [m] between points of the shifted path, and between offsets tried

/// The path from the robot on, in steps of kStep: points and left normals in the base frame.
struct Stretch {
  std::vector<Eigen::Vector2d> points_in_base;
  std::vector<Eigen::Vector2d> normals_in_base;
};

Stretch stretch_ahead(const Aim& aim, const Path& path, const Pose2& map_from_base, double horizon_m) {
  const Pose2 base_from_map = inverse(map_from_base);
  Stretch stretch;
  const double end = std::min(path.length_m(), aim.way_m + horizon_m);
  for (double way = aim.way_m; way <= end; way += kStep) {
    const Eigen::Vector2d along = path.point_at(way + kStep) - path.point_at(way - kStep);
    const double length = along.norm();
    if (length < 1e-6) continue;
    stretch.points_in_base.push_back(base_from_map * path.point_at(way));
    const Eigen::Vector2d normal_in_map = Eigen::Vector2d{-along.y(), along.x()} / length;
    stretch.normals_in_base.push_back(base_from_map * (map_from_base.position() + normal_in_map));
  }
  return stretch;
}

double distance_from(const std::vector<Eigen::Vector2d>& line, const Eigen::Vector2d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& on_line : line) least = std::min(least, (on_line - point).squaredNorm());
  return std::sqrt(least);  // the line's points are kStep apart: at 0.3 m this is 4 mm too much at most
}

}  // namespace

std::optional<SideStep> side_step(const Aim& aim, const Path& path, const Pose2& map_from_base,
                                  const std::vector<Eigen::Vector2d>& obstacles_in_base,
                                  const SideStepOptions& options) {
  const Stretch stretch = stretch_ahead(aim, path, map_from_base, options.horizon_m);
  if (stretch.points_in_base.size() < 2) return std::nullopt;

  std::vector<Eigen::Vector2d> near;
  for (const auto& point : obstacles_in_base) {
    if (point.x() < options.hull_front_m) continue;
    if (distance_from(stretch.points_in_base, point) < options.max_offset_m + options.half_width_m)
      near.push_back(point);
  }
  // How far it may take to reach the offset: up to where the first obstacle stands on the path itself.
  std::size_t reach = stretch.points_in_base.size() - 1;
  for (std::size_t i = 0; i < reach; ++i) {
    const bool stands_here = std::any_of(near.begin(), near.end(), [&](const Eigen::Vector2d& point) {
      return (point - stretch.points_in_base[i]).norm() < options.half_width_m;
    });
    if (stands_here) reach = i;
  }
  reach = reach > 7 ? reach - 3 : 4;  // a pursuit lags behind the line it pursues
  const double present_m = -stretch.normals_in_base.front().dot(stretch.points_in_base.front());

  std::optional<SideStep> best;
  double best_cost = std::numeric_limits<double>::infinity();
  const int offsets = static_cast<int>(options.max_offset_m / kStep);
  std::vector<Eigen::Vector2d> shifted(stretch.points_in_base.size());
  for (int i = -offsets; i <= offsets; ++i) {
    const double offset = kStep * i;
    const double cost = std::abs(offset) + 0.5 * std::abs(offset - options.last_offset_m);
    if (cost >= best_cost) continue;
    for (std::size_t k = 0; k < shifted.size(); ++k) {
      const double share = std::min(1.0, static_cast<double>(k) / static_cast<double>(reach));
      shifted[k] = stretch.points_in_base[k] + (present_m + share * (offset - present_m)) * stretch.normals_in_base[k];
    }
    const bool clear = std::none_of(near.begin(), near.end(), [&](const Eigen::Vector2d& point) {
      return distance_from(shifted, point) < options.half_width_m;
    });
    if (!clear) continue;
    best_cost = cost;
    const auto ahead = static_cast<std::size_t>(std::lround(options.lookahead_m / kStep));
    best = SideStep{offset, shifted[std::min(ahead, shifted.size() - 1)]};
  }
  return best;
}

}  // namespace tandem::navigator
