#include "services/simulator/core/wheels.hpp"

#include <algorithm>
#include <cmath>

namespace tandem::simulator {

WheelSpeeds wheels_of(const BodySpeed& body, double half_track_m) {
  const double turning = body.turn_rate_radps * half_track_m;
  return {body.forward_mps - turning, body.forward_mps + turning};
}

BodySpeed body_of(const WheelSpeeds& wheels, double half_track_m) {
  return {(wheels.left_mps + wheels.right_mps) / 2.0, (wheels.right_mps - wheels.left_mps) / (2.0 * half_track_m)};
}

double ramped(double value, double target, double most_up, double most_down) {
  if (value > 0.0 && target < value) return std::max(value - most_down, std::max(target, 0.0));
  if (value < 0.0 && target > value) return std::min(value + most_down, std::min(target, 0.0));
  return std::clamp(target, value - most_up, value + most_up);
}

Pose2 arc(const BodySpeed& speed, double dt_s) {
  const double turn = speed.turn_rate_radps * dt_s;
  const double way = speed.forward_mps * dt_s;
  if (std::abs(turn) < 1e-9) return {way, 0.0, turn};
  return {way * std::sin(turn) / turn, way * (1.0 - std::cos(turn)) / turn, turn};
}

Pose2 slipped(const Pose2& wheel_motion, const SlipModel& slip, Rng& rng) {
  const double way = std::hypot(wheel_motion.x, wheel_motion.y);
  const double turn = std::abs(wheel_motion.heading);
  if (way == 0.0 && turn == 0.0) return wheel_motion;
  const double turn_noise =
      rng.normal() * slip.turn_per_root_rad * std::sqrt(turn) + rng.normal() * slip.turn_per_root_m * std::sqrt(way);
  return {wheel_motion.x + rng.normal() * slip.distance_per_root_m * std::sqrt(way), wheel_motion.y,
          wrap_to_pi(wheel_motion.heading + turn_noise)};
}

}  // namespace tandem::simulator
