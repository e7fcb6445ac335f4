#include "robot/safety/core/swept_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tandem::safety {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kStraight = 1e-6;  ///< [rad/s]

bool is_inside(const Hull& hull, const Eigen::Vector2d& point) {
  return std::abs(point.x()) <= hull.half_length_m && std::abs(point.y()) <= hull.half_width_m;
}

/// Whether a point beside the hull comes closer to the side it lies at.
bool comes_closer(const Hull& hull, const Motion& motion, const Eigen::Vector2d& point) {
  const double velocity_x = -motion.forward_mps + motion.turn_rate_radps * point.y();
  const double velocity_y = -motion.turn_rate_radps * point.x();
  const double beyond_end = std::abs(point.x()) - hull.half_length_m;
  const double beyond_side = std::abs(point.y()) - hull.half_width_m;
  const double outwards = beyond_end > beyond_side ? std::copysign(1.0, point.x()) * velocity_x
                                                   : std::copysign(1.0, point.y()) * velocity_y;
  return outwards < -1e-9;
}

double straight_time(const Hull& hull, double forward_mps, const Eigen::Vector2d& point) {
  const double ahead = forward_mps > 0.0 ? point.x() : -point.x();
  if (forward_mps == 0.0 || std::abs(point.y()) > hull.half_width_m || ahead < hull.half_length_m) return kNever;
  return (ahead - hull.half_length_m) / std::abs(forward_mps);
}

double arc_time(const Hull& hull, const Motion& motion, const Eigen::Vector2d& point) {
  const double turn_rate = motion.turn_rate_radps;
  const double centre_y = motion.forward_mps / turn_rate;
  const double radius = std::hypot(point.x(), point.y() - centre_y);
  const double farthest = std::hypot(hull.half_length_m, std::abs(centre_y) + hull.half_width_m);
  const double nearest = std::max(0.0, std::abs(centre_y) - hull.half_width_m);
  if (radius > farthest || radius < nearest) return kNever;

  const double start = std::atan2(point.y() - centre_y, point.x());
  double smallest_turn = kNever;
  const auto crossing = [&](double x, double y_from_centre) {
    const double turn_of_point = start - std::atan2(y_from_centre, x);  // it turns against the robot
    double turn = turn_rate > 0.0 ? turn_of_point : -turn_of_point;
    turn -= 2.0 * std::numbers::pi * std::floor(turn / (2.0 * std::numbers::pi));
    smallest_turn = std::min(smallest_turn, turn);
  };
  for (const double sign : {-1.0, 1.0}) {
    const double end_x = sign * hull.half_length_m;
    if (radius >= hull.half_length_m) {
      const double half_chord = std::sqrt(radius * radius - end_x * end_x);
      for (const double y : {-half_chord, half_chord}) {
        if (std::abs(centre_y + y) <= hull.half_width_m) crossing(end_x, y);
      }
    }
    const double side_y = sign * hull.half_width_m - centre_y;
    if (radius >= std::abs(side_y)) {
      const double half_chord = std::sqrt(radius * radius - side_y * side_y);
      for (const double x : {-half_chord, half_chord}) {
        if (std::abs(x) <= hull.half_length_m) crossing(x, side_y);
      }
    }
  }
  return smallest_turn / std::abs(turn_rate);
}

}  // namespace

double Hull::corner_radius_m() const {
  return std::hypot(half_length_m, half_width_m);
}

double distance_to_hull(const Hull& hull, const Eigen::Vector2d& point_in_base) {
  return std::hypot(std::max(0.0, std::abs(point_in_base.x()) - hull.half_length_m),
                    std::max(0.0, std::abs(point_in_base.y()) - hull.half_width_m));
}

double time_to_contact(const Hull& hull, double margin_m, const Motion& motion, const Eigen::Vector2d& point_in_base) {
  if (is_inside(hull, point_in_base)) return 0.0;
  const Hull grown = hull.grown(margin_m);
  if (is_inside(grown, point_in_base)) return comes_closer(hull, motion, point_in_base) ? 0.0 : kNever;
  if (std::abs(motion.turn_rate_radps) < kStraight) return straight_time(grown, motion.forward_mps, point_in_base);
  return arc_time(grown, motion, point_in_base);
}

double time_to_contact(const Hull& hull, double margin_m, const Motion& motion,
                       std::span<const Eigen::Vector2d> points_in_base) {
  double earliest = kNever;
  for (const auto& point : points_in_base) {
    earliest = std::min(earliest, time_to_contact(hull, margin_m, motion, point));
  }
  return earliest;
}

double speed_that_stops_within(double free_m, double reaction_s, double deceleration_mps2, double margin_m) {
  const double room = free_m - margin_m;
  if (!(room > 0.0)) return 0.0;
  return deceleration_mps2 * (std::sqrt(reaction_s * reaction_s + 2.0 * room / deceleration_mps2) - reaction_s);
}

}  // namespace tandem::safety
