#include "services/navigator/core/path_follower.hpp"

#include <algorithm>
#include <cmath>

namespace tandem::navigator {

void PathFollower::begin(Path path, const Eigen::Vector2d& position_in_map) {
  constexpr double kFirstMetres = 5.0;  // a plan is a few seconds old when it is accepted
  constexpr double kPreference = 0.05;
  path_ = std::move(path);
  way_m_ = path_.empty() ? 0.0 : path_.nearest(position_in_map, 0.0, kFirstMetres, kPreference).way_m;
  turning_ = false;
}

Aim PathFollower::aim(const Pose2& map_from_base, double speed_mps) {
  constexpr double kAhead =
      1.5;  // [m] of path searched for the nearest place: not the next lap of a path that comes back
  const Path::Place place = path_.nearest(map_from_base.position(), way_m_, way_m_ + kAhead, 0.01);
  way_m_ = place.way_m;

  Aim aim;
  aim.way_m = way_m_;
  aim.remaining_m = path_.length_m() - way_m_;
  aim.cross_track_m = place.distance_m;
  aim.arrived = aim.remaining_m <= config_.goal_tolerance_m &&
                (path_.goal() - map_from_base.position()).norm() <= config_.goal_tolerance_m;

  constexpr double kOffPath = 0.15;  // [m] farther off it comes back at an angle, not straight across
  const double lookahead_m =
      std::clamp(speed_mps * config_.lookahead_s, config_.min_lookahead_m, config_.max_lookahead_m) +
      1.5 * std::max(0.0, place.distance_m - kOffPath);
  aim.point_in_base = inverse(map_from_base) * path_.point_at(way_m_ + lookahead_m);
  const double distance = aim.point_in_base.norm();
  if (distance < 1e-6) return aim;
  aim.bearing_rad = std::atan2(aim.point_in_base.y(), aim.point_in_base.x());
  aim.curvature = 2.0 * std::sin(aim.bearing_rad) / distance;
  turning_ = std::abs(aim.bearing_rad) > (turning_ ? config_.turn_in_place_until_rad : config_.turn_in_place_from_rad);
  aim.turn_in_place = turning_;
  return aim;
}

}  // namespace tandem::navigator
