#pragma once

#include <Eigen/Core>
#include <cmath>

#include "services/common/angle.hpp"

namespace tandem {

/// A position and heading in the plane, or the rigid transform `a_from_b` that places frame b in frame a.
///
/// Transforms compose so that inner names cancel: map_from_laser = map_from_base * base_from_laser.
struct Pose2 {
  double x = 0.0;        ///< [m]
  double y = 0.0;        ///< [m]
  double heading = 0.0;  ///< [rad], counter-clockwise from the x axis

  [[nodiscard]] Eigen::Vector2d position() const { return {x, y}; }

  friend bool operator==(const Pose2&, const Pose2&) = default;
};

/// Velocity of the base in its own frame.
struct Twist2 {
  double forward_mps = 0.0;
  double left_mps = 0.0;
  double turn_rate_radps = 0.0;

  friend bool operator==(const Twist2&, const Twist2&) = default;
};

/// Covariance of (x [m], y [m], heading [rad]).
using Covariance3 = Eigen::Matrix3d;

/// Composition: `a_from_b * b_from_c` is a_from_c. The heading is wrapped into [-pi, pi).
[[nodiscard]] inline Pose2 operator*(const Pose2& a_from_b, const Pose2& b_from_c) {
  const double c = std::cos(a_from_b.heading);
  const double s = std::sin(a_from_b.heading);
  return {a_from_b.x + c * b_from_c.x - s * b_from_c.y, a_from_b.y + s * b_from_c.x + c * b_from_c.y,
          wrap_to_pi(a_from_b.heading + b_from_c.heading)};
}

/// The point `p_in_b` [m] seen in frame a.
[[nodiscard]] inline Eigen::Vector2d operator*(const Pose2& a_from_b, const Eigen::Vector2d& p_in_b) {
  const double c = std::cos(a_from_b.heading);
  const double s = std::sin(a_from_b.heading);
  return {a_from_b.x + c * p_in_b.x() - s * p_in_b.y(), a_from_b.y + s * p_in_b.x() + c * p_in_b.y()};
}

/// `b_from_a` of `a_from_b`.
[[nodiscard]] inline Pose2 inverse(const Pose2& a_from_b) {
  const double c = std::cos(a_from_b.heading);
  const double s = std::sin(a_from_b.heading);
  return {-c * a_from_b.x - s * a_from_b.y, s * a_from_b.x - c * a_from_b.y, wrap_to_pi(-a_from_b.heading)};
}

/// The pose at `share` in [0, 1] of the way from `from` to `to`: straight line, shortest turn.
[[nodiscard]] inline Pose2 interpolate(const Pose2& from, const Pose2& to, double share) {
  return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y),
          wrap_to_pi(from.heading + share * turn_between(from.heading, to.heading))};
}

}  // namespace tandem
