#include "robot/safety/core/speed_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tandem::safety {
namespace {

/// An arc whose centre lies under the robot is a turn in place.
bool is_turn_in_place(const Hull& hull, const Motion& motion) {
  return motion.turn_rate_radps != 0.0 &&
         std::abs(motion.forward_mps) < hull.half_width_m * std::abs(motion.turn_rate_radps);
}

PathLimit limited_turn(const GateConfig& config, const Hull& hull, const Motion& wanted,
                       std::span<const Eigen::Vector2d> points_in_base) {
  const double swept_m = hull.corner_radius_m() + config.turn_clearance_m;
  bool near = false;
  for (const auto& point : points_in_base) {
    if (point.norm() < swept_m) return {Motion{}, true};
    near = near || distance_to_hull(hull, point) < config.near_turn_distance_m;
  }
  const double rate = std::abs(wanted.turn_rate_radps);
  const double share = near && rate > config.near_turn_rate_radps ? config.near_turn_rate_radps / rate : 1.0;
  return {{share * wanted.forward_mps, share * wanted.turn_rate_radps}, false};
}

}  // namespace

double speed_near_person(double distance_m, double otherwise_mps) {
  if (distance_m > 2.5) return otherwise_mps;
  if (distance_m >= 1.2) return std::min(0.4, otherwise_mps);
  if (distance_m >= 0.6) return std::min(0.2, otherwise_mps);
  return 0.0;
}

double nearest_person_m(const Hull& hull, const PeopleInput& people) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& person : people.in_base) nearest = std::min(nearest, distance_to_hull(hull, person));
  return nearest;
}

double speed_limit_mps(const GateConfig& config, const Hull& hull, const PeopleInput& people, const BaseInput& base) {
  double limit = speed_near_person(nearest_person_m(hull, people), config.max_speed_mps);
  if (!people.age_s || *people.age_s > config.people_timeout_s) {
    limit = std::min(limit, config.unknown_people_speed_mps);
  }
  const bool brakes_known = base.watchdog_s > 0.0 && base.watchdog_s <= config.max_watchdog_s &&
                            base.deceleration_mps2 >= config.deceleration_mps2 - 1e-6;
  return brakes_known ? limit : std::min(limit, config.unknown_brakes_speed_mps);
}

PathLimit limited_by_surroundings(const GateConfig& config, const Hull& hull, double deceleration_mps2, double late_s,
                                  const Motion& wanted, std::span<const Eigen::Vector2d> points_in_base) {
  if (wanted == Motion{}) return {wanted, false};
  const double contact_s = time_to_contact(hull, config.side_margin_m, wanted, points_in_base);
  if (contact_s == 0.0) return {Motion{}, true};  // also a jacket before the laser
  if (is_turn_in_place(hull, wanted)) return limited_turn(config, hull, wanted, points_in_base);

  const double speed =
      std::max(std::abs(wanted.forward_mps), std::abs(wanted.turn_rate_radps) * hull.corner_radius_m());
  const double free_m = speed * contact_s;  // of the outermost corner, where that is faster than the centre
  const double stopping_mps =
      speed_that_stops_within(free_m, config.reaction_time_s + late_s, deceleration_mps2, config.stop_margin_m);
  double allowed_share = std::min(1.0, stopping_mps / speed);
  const double forward = std::abs(wanted.forward_mps);
  if (forward * contact_s < config.narrow_view_m) {
    allowed_share = std::min(allowed_share, config.narrow_view_speed_mps / forward);
  }
  return {{allowed_share * wanted.forward_mps, allowed_share * wanted.turn_rate_radps}, allowed_share <= 0.0};
}

}  // namespace tandem::safety
