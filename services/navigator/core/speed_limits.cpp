#include "services/navigator/core/speed_limits.hpp"

#include <algorithm>
#include <cmath>

namespace tandem::navigator {

bool comes_up_from_behind(const Pose2& map_from_base, const WalkingPerson& person, double distance_m) {
  constexpr double kWalks = 0.2;                 // [m/s] slower is standing
  constexpr double kAhead = 0.7071067811865476;  // cosine of 45 degrees
  constexpr double kAway = 0.5;                  // cosine of 60 degrees
  const Eigen::Vector2d to_person = person.position_in_map - map_from_base.position();
  const double distance = to_person.norm();
  const double speed = person.velocity_in_map_mps.norm();
  if (distance > distance_m || distance < 1e-6 || speed < kWalks) return false;
  const Eigen::Vector2d heading{std::cos(map_from_base.heading), std::sin(map_from_base.heading)};
  return heading.dot(to_person) > kAhead * distance &&
         person.velocity_in_map_mps.dot(to_person) > kAway * speed * distance;
}

double speed_limit(const NavigatorConfig& config, const Course& course, const Aim& aim, const Pose2& map_from_base,
                   PoseQuality quality, const std::vector<WalkingPerson>& people) {
  constexpr double kCreep = 0.08;  // [m/s] so that it gets to the goal
  double limit = config.max_speed_mps;
  if (quality != PoseQuality::Good) limit = std::min(limit, config.uncertain_speed_mps);
  const double bend = std::abs(course.curvature);
  if (bend > 1e-3) {
    limit =
        std::min({limit, config.max_turn_rate_radps / bend, std::sqrt(config.max_lateral_acceleration_mps2 / bend)});
  }
  limit = std::min(limit, std::max(kCreep, std::sqrt(2.0 * config.goal_deceleration_mps2 * aim.remaining_m)));
  limit = std::min(limit, speed_that_stops_within(course.free.way_m - config.stop_margin_m, config.reaction_time_s,
                                                  config.deceleration_mps2));
  if (course.free.way_m < config.narrow_view_m) limit = std::min(limit, config.narrow_view_speed_mps);
  for (const auto& person : people) {
    if (comes_up_from_behind(map_from_base, person, config.person_behind_distance_m)) {
      limit = std::min(limit, config.narrow_view_speed_mps);
    }
  }
  return limit;
}

Twist2 limited_acceleration(const NavigatorConfig& config, const Twist2& last, const Twist2& wanted,
                            double measured_mps) {
  constexpr double kAheadOfWheels = 0.25;  // [m/s]
  Twist2 limited = wanted;
  const double fastest = std::min(std::max(0.0, last.forward_mps) + config.acceleration_mps2 * config.period_s,
                                  std::max(0.0, measured_mps) + kAheadOfWheels);
  if (wanted.forward_mps > fastest) {
    limited.forward_mps = fastest;
    if (wanted.forward_mps > 1e-9) limited.turn_rate_radps *= fastest / wanted.forward_mps;  // stays on the same arc
  }
  if (wanted.forward_mps <= 1e-9) {  // in place
    const double step = config.turn_acceleration_radps2 * config.period_s;
    const double slowest = std::min(0.0, last.turn_rate_radps) - step;
    const double greatest = std::max(0.0, last.turn_rate_radps) + step;
    limited.turn_rate_radps = std::clamp(wanted.turn_rate_radps, slowest, greatest);
  }
  return limited;
}

}  // namespace tandem::navigator
