#include "services/navigator/core/avoidance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "services/navigator/core/side_step.hpp"

namespace tandem::navigator {
namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLeastWay = 0.15;  ///< [m] A shorter arc is not worth beginning.

double distance_from_centre(const Eigen::Vector2d& centre_in_base, const Points& obstacles_in_base) {
  double least = kInfinity;
  for (const auto& point : obstacles_in_base) least = std::min(least, (point - centre_in_base).squaredNorm());
  return std::sqrt(least);
}

/// True if nothing lies within `room_m` of the straight line between the two points.
bool is_clear(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double room_m, const Points& obstacles) {
  const Eigen::Vector2d line = to - from;
  const double square = std::max(1e-12, line.squaredNorm());
  return std::none_of(obstacles.begin(), obstacles.end(), [&](const Eigen::Vector2d& point) {
    const double share = std::clamp(line.dot(point - from) / square, 0.0, 1.0);
    return (from + share * line - point).squaredNorm() < room_m * room_m;
  });
}

}  // namespace

Avoidance::Avoidance(const NavigatorConfig& config)
    : config_(config), hull_{config.hull_length_m, config.hull_width_m} {
  const double tightest = 1.0 / config.min_turn_radius_m;
  for (const double share : {0.0, 0.06, 0.12, 0.2, 0.3, 0.45, 0.7, 1.0}) {
    curvatures_.push_back(share * tightest);
    if (share > 0.0) curvatures_.push_back(-share * tightest);
  }
}

Course Avoidance::course(const Aim& aim, const Path& path, const Pose2& map_from_base,
                         const Points& obstacles_in_base) {
  Course wanted;
  wanted.nearest_m = kInfinity;
  for (const auto& point : obstacles_in_base) wanted.nearest_m = std::min(wanted.nearest_m, distance_to(hull_, point));

  if (aim.turn_in_place) {
    const double ring = turning_ ? config_.turning_margin_m : config_.turn_margin_m;
    turning_ = distance_from_centre({0.0, 0.0}, obstacles_in_base) > hull_.circumscribed_radius_m() + ring;
    if (turning_) {
      wanted.kind = Course::Kind::TurnInPlace;
      return wanted;
    }
    if (auto course = way_to_room(aim, obstacles_in_base)) {
      course->nearest_m = wanted.nearest_m;
      last_curvature_ = course->curvature;
      return *course;
    }
    wanted.free = free_way(hull_, config_.side_margin_m, 0.0, obstacles_in_base);
    return wanted;
  }
  turning_ = false;

  const double tightest = 1.0 / config_.min_turn_radius_m;
  wanted.curvature = std::clamp(aim.curvature, -tightest, tightest);
  wanted.free = free_way(hull_, config_.side_margin_m, wanted.curvature, obstacles_in_base);
  const double needed_m = std::min(aim.remaining_m, aim.point_in_base.norm()) + config_.stop_margin_m;
  if (wanted.free.way_m >= needed_m && path_is_free(aim, path, map_from_base, obstacles_in_base)) {
    wanted.kind = Course::Kind::Arc;
    last_curvature_ = wanted.curvature;
    last_offset_m_ = 0.0;
    return wanted;
  }
  if (auto course = aside(aim, path, map_from_base, obstacles_in_base)) {
    course->nearest_m = wanted.nearest_m;
    last_curvature_ = course->curvature;
    return *course;
  }
  last_offset_m_ = 0.0;
  if (auto course = detour(aim, path, map_from_base, obstacles_in_base)) {
    course->nearest_m = wanted.nearest_m;
    last_curvature_ = course->curvature;
    return *course;
  }
  constexpr double kRest = 0.02;                                                           // [m]
  if (wanted.free.way_m > config_.stop_margin_m + kRest) wanted.kind = Course::Kind::Arc;  // up to the obstacle
  return wanted;
}

bool Avoidance::path_is_free(const Aim& aim, const Path& path, const Pose2& map_from_base,
                             const Points& obstacles_in_base) const {
  const double half_width = 0.5 * config_.hull_width_m + config_.side_margin_m;
  const double last = aim.way_m + config_.horizon_m;
  return std::none_of(obstacles_in_base.begin(), obstacles_in_base.end(), [&](const Eigen::Vector2d& point) {
    if (point.norm() > config_.horizon_m + 1.0) return false;
    // What is beside the robot now is no reason to leave the path: the arc itself has been checked.
    if (point.x() < 0.5 * config_.hull_length_m) return false;
    return path.nearest(map_from_base * point, aim.way_m, last).distance_m < half_width;
  });
}

std::optional<Course> Avoidance::aside(const Aim& aim, const Path& path, const Pose2& map_from_base,
                                       const Points& obstacles_in_base) {
  const auto step = side_step(aim, path, map_from_base, obstacles_in_base,
                              {.half_width_m = 0.5 * config_.hull_width_m + config_.side_margin_m,
                               .hull_front_m = 0.5 * config_.hull_length_m,
                               .horizon_m = config_.horizon_m,
                               .max_offset_m = config_.max_detour_m,
                               .lookahead_m = config_.max_lookahead_m,
                               .last_offset_m = last_offset_m_});
  if (!step || step->point_in_base.x() <= 0.0) return std::nullopt;
  const double tightest = 1.0 / config_.min_turn_radius_m;
  const double curvature =
      std::clamp(2.0 * step->point_in_base.y() / step->point_in_base.squaredNorm(), -tightest, tightest);
  const FreeWay free = free_way(hull_, config_.side_margin_m, curvature, obstacles_in_base);
  if (free.way_m < config_.stop_margin_m + kLeastWay) return std::nullopt;
  last_offset_m_ = step->offset_m;
  return Course{.kind = Course::Kind::Arc, .curvature = curvature, .free = free, .detour = true};
}

std::optional<Course> Avoidance::detour(const Aim& aim, const Path& path, const Pose2& map_from_base,
                                        const Points& obstacles_in_base) const {
  // Where to be back on the path: behind the first place from the nearest obstacle on where the hull has room again.
  constexpr double kToComeBack = 1.0;  // [m] of path for coming back
  const Pose2 base_from_map = inverse(map_from_base);
  const double room_m = 0.5 * config_.hull_width_m + config_.side_margin_m;
  const double last_m = std::min(aim.way_m + 2.0 * config_.horizon_m, path.length_m());
  double rejoin_m = std::min(aim.way_m + config_.horizon_m, path.length_m());
  while (rejoin_m < last_m &&
         distance_from_centre(base_from_map * path.point_at(rejoin_m), obstacles_in_base) < room_m) {
    rejoin_m += 0.1;
  }
  rejoin_m = std::min(rejoin_m + kToComeBack, path.length_m());
  const Eigen::Vector2d rejoin_in_base = base_from_map * path.point_at(rejoin_m);
  const double rejoin_distance = rejoin_in_base.norm();

  std::optional<Course> best;
  double best_cost = kInfinity;
  const auto attempt = [&](double curvature) {
    const FreeWay free = free_way(hull_, config_.side_margin_m, curvature, obstacles_in_base);
    const double longest = std::min({free.way_m - config_.stop_margin_m, 1.2, rejoin_distance});
    for (int quarter = 1; quarter <= 4; ++quarter) {  // a tight arc is good for a part of it only
      const double way = 0.25 * quarter * longest;
      if (way < kLeastWay) continue;
      const Pose2 end = start_from_end(curvature, way);
      if (path.nearest(map_from_base * end.position(), aim.way_m, last_m).distance_m >
          std::max(config_.max_detour_m, aim.cross_track_m)) {
        return;
      }
      const Eigen::Vector2d left = inverse(end) * rejoin_in_base;
      const double clearance = distance_from_centre(end.position(), obstacles_in_base);
      const bool sees_rejoin = is_clear(end.position(), rejoin_in_base, room_m, obstacles_in_base);
      const double cost = way + left.norm() +
                          (left.norm() > 0.1 ? 0.4 * std::abs(std::atan2(left.y(), left.x())) : 0.0) +
                          0.15 / std::max(0.1, clearance - 0.2) + 0.05 * std::abs(curvature - last_curvature_) +
                          (sees_rejoin ? 0.0 : 1.0);
      if (cost < best_cost) {
        best_cost = cost;
        best = Course{.kind = Course::Kind::Arc, .curvature = curvature, .free = free, .detour = true};
      }
    }
  };
  for (const double curvature : curvatures_) attempt(curvature);
  const double tightest = 1.0 / config_.min_turn_radius_m;
  attempt(std::clamp(aim.curvature, -tightest, tightest));
  return best;
}

std::optional<Course> Avoidance::way_to_room(const Aim& aim, const Points& obstacles_in_base) const {
  const double room_m = hull_.circumscribed_radius_m() + config_.turn_margin_m;
  std::optional<Course> best;
  double best_cost = kInfinity;
  for (const double curvature : curvatures_) {
    const FreeWay free = free_way(hull_, config_.side_margin_m, curvature, obstacles_in_base);
    for (double way = kLeastWay; way < std::min(1.8, free.way_m - config_.stop_margin_m); way += 0.15) {
      const Pose2 end = start_from_end(curvature, way);
      const Eigen::Vector2d left = inverse(end) * aim.point_in_base;
      const double bearing = std::abs(std::atan2(left.y(), left.x()));
      const bool room =
          bearing < config_.turn_in_place_from_rad || distance_from_centre(end.position(), obstacles_in_base) > room_m;
      const double cost = way + 0.5 * bearing + 0.2 * std::abs(curvature - last_curvature_) + (room ? 0.0 : 3.0);
      if (cost < best_cost) {
        best_cost = cost;
        best = Course{.kind = Course::Kind::Arc, .curvature = curvature, .free = free, .detour = true};
      }
    }
  }
  return best;
}

}  // namespace tandem::navigator
