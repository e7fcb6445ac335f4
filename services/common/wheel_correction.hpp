#pragma once

#include <cmath>

#include "services/common/config.hpp"
#include "services/common/pose2.hpp"

namespace tandem {

/// How the wheels differ from what the controller takes them for. Part of base.toml, from `tandem calibrate odometry`.
///
/// A robot with two driven sides goes (left + right) / 2 ahead and turns by (right - left) / track. On a skid-steered
/// one the track is that of a robot with two wheels that would turn alike: wider than the hull, and another on carpet.
struct WheelCorrection {
  double left_wheel_scale = 1.0;   ///< True radius of the left wheel over the one that the controller counts with.
  double right_wheel_scale = 1.0;  ///< The same of the right wheel.
  double track_scale = 1.0;        ///< True distance between the wheels over the one that the controller counts with.

  template <typename Visitor>
  void visit_fields(Visitor& visitor) {
    visitor.field("left_wheel_scale", left_wheel_scale, Range{0.5, 2.0});
    visitor.field("right_wheel_scale", right_wheel_scale, Range{0.5, 2.0});
    visitor.field("track_scale", track_scale, Range{0.3, 3.0});
  }

  friend bool operator==(const WheelCorrection&, const WheelCorrection&) = default;
};

/// A motion at constant velocity, in the frame that moves. `Scalar` may carry derivatives.
template <typename Scalar>
struct Arc {
  Scalar forward_m;
  Scalar left_m;
  Scalar turn_rad;
};

/// The arc that ends at `motion`.
[[nodiscard]] inline Arc<double> arc_to(const Pose2& motion) {
  const double half = 0.5 * motion.heading;
  const double along = std::abs(half) < 1e-4 ? 1.0 - half * half / 3.0 : half / std::tan(half);
  return {along * motion.x + half * motion.y, along * motion.y - half * motion.x, motion.heading};
}

/// Where `arc` ends, heading not wrapped: x, y [m] and heading [rad].
template <typename Scalar>
[[nodiscard]] Arc<Scalar> chord_of(const Arc<Scalar>& arc) {
  using std::abs;
  using std::cos;
  using std::sin;
  const Scalar& turn = arc.turn_rad;
  Scalar ahead = Scalar(1.0) - turn * turn / 6.0;
  Scalar aside = turn / 2.0;
  if (abs(turn) > 1e-4) {
    ahead = sin(turn) / turn;
    aside = (Scalar(1.0) - cos(turn)) / turn;
  }
  return {ahead * arc.forward_m - aside * arc.left_m, aside * arc.forward_m + ahead * arc.left_m, turn};
}

/// The arc that the robot drove when the controller reports `reported`; `half_track_m` is what the controller counts
/// with.
template <typename Scalar>
[[nodiscard]] Arc<Scalar> corrected(const Arc<double>& reported, double half_track_m, const Scalar& left_wheel_scale,
                                    const Scalar& right_wheel_scale, const Scalar& track_scale) {
  const Scalar left_m = left_wheel_scale * (reported.forward_m - half_track_m * reported.turn_rad);
  const Scalar right_m = right_wheel_scale * (reported.forward_m + half_track_m * reported.turn_rad);
  return {0.5 * (left_m + right_m), Scalar(reported.left_m), (right_m - left_m) / (2.0 * half_track_m * track_scale)};
}

/// The motion that the robot made when the controller reports `reported`.
[[nodiscard]] inline Pose2 corrected(const Pose2& reported, double half_track_m, const WheelCorrection& wheels) {
  const Arc<double> end = chord_of(corrected<double>(arc_to(reported), half_track_m, wheels.left_wheel_scale,
                                                     wheels.right_wheel_scale, wheels.track_scale));
  return {end.forward_m, end.left_m, wrap_to_pi(end.turn_rad)};
}

}  // namespace tandem
