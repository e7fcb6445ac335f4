#pragma once

#include "services/common/pose2.hpp"
#include "services/common/random.hpp"

namespace tandem::simulator {

/// Speed of the two sides of a differential drive over ground [m/s].
struct WheelSpeeds {
  double left_mps = 0.0;
  double right_mps = 0.0;

  friend bool operator==(const WheelSpeeds&, const WheelSpeeds&) = default;
};

/// How the wheels of a body are told to go, as one speed ahead and one turn rate.
struct BodySpeed {
  double forward_mps = 0.0;
  double turn_rate_radps = 0.0;  ///< Counter-clockwise positive.

  friend bool operator==(const BodySpeed&, const BodySpeed&) = default;
};

/// Wheels `half_track_m` to the left and right of the middle: right = forward + turn rate x half track.
[[nodiscard]] WheelSpeeds wheels_of(const BodySpeed& body, double half_track_m);
[[nodiscard]] BodySpeed body_of(const WheelSpeeds& wheels, double half_track_m);

/// `value` moved towards `target` by at most `most_up` where that takes it away from 0, `most_down` where it takes it
/// towards 0; a change of sign stops at 0 first.
[[nodiscard]] double ramped(double value, double target, double most_up, double most_down);

/// base_from_next_base after `dt_s` at constant `speed`: an arc.
[[nodiscard]] Pose2 arc(const BodySpeed& speed, double dt_s);

/// How wheels slip on the floor. Standard deviations grow with the root of the way, as a random walk does.
struct SlipModel {
  double distance_per_root_m = 0.01;  ///< Of the way ahead, per root of the way [m / sqrt(m)].
  double turn_per_root_rad = 0.02;    ///< Of the turn, per root of the turn [rad / sqrt(rad)].
  double turn_per_root_m = 0.01;      ///< Of the turn, per root of the way ahead [rad / sqrt(m)].
};

/// What the floor makes of `wheel_motion`, the motion that the wheels measured.
[[nodiscard]] Pose2 slipped(const Pose2& wheel_motion, const SlipModel& slip, Rng& rng);

}  // namespace tandem::simulator
