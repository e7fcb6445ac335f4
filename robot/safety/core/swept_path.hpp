#pragma once

#include <Eigen/Core>
#include <span>

namespace tandem::safety {

/// The robot's outline: a rectangle around the base's centre.
struct Hull {
  double half_length_m = 0.313;
  double half_width_m = 0.2525;

  [[nodiscard]] Hull grown(double by_m) const { return {half_length_m + by_m, half_width_m + by_m}; }
  /// Radius of the circle swept by a turn in place.
  [[nodiscard]] double corner_radius_m() const;
};

/// Speed along an arc: forward and turning at constant rates.
struct Motion {
  double forward_mps = 0.0;
  double turn_rate_radps = 0.0;

  friend bool operator==(const Motion& a, const Motion& b) {
    return a.forward_mps == b.forward_mps && a.turn_rate_radps == b.turn_rate_radps;
  }
};

/// The distance from the hull to `point_in_base`; 0 inside [m].
[[nodiscard]] double distance_to_hull(const Hull& hull, const Eigen::Vector2d& point_in_base);

/// When the hull, going on as `motion` says, touches `point_in_base` [s]; infinite if never. 0 inside the hull.
///
/// In the base's own view a point moves on a circle around the centre of the turn: the answer is the first crossing of
/// that circle with an edge of the rectangle. `margin_m` grows the rectangle; a point in the margin alone counts only
/// while it comes closer, so that a robot beside a wall may drive on and away.
[[nodiscard]] double time_to_contact(const Hull& hull, double margin_m, const Motion& motion,
                                     const Eigen::Vector2d& point_in_base);

/// The earliest contact with any of `points_in_base` [s].
[[nodiscard]] double time_to_contact(const Hull& hull, double margin_m, const Motion& motion,
                                     std::span<const Eigen::Vector2d> points_in_base);

/// The largest speed from which the robot stands within `free_m`: v t + v^2 / (2 a) + margin = free.
[[nodiscard]] double speed_that_stops_within(double free_m, double reaction_s, double deceleration_mps2,
                                             double margin_m);

}  // namespace tandem::safety
