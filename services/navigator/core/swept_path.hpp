#pragma once

#include <Eigen/Core>
#include <vector>

#include "services/common/pose2.hpp"

namespace tandem::navigator {

/// The robot seen from above: a rectangle around the origin of its base frame, x ahead.
struct Hull {
  double length_m = 0.0;
  double width_m = 0.0;

  /// Radius of the circle that the corners draw when it turns in place.
  [[nodiscard]] double circumscribed_radius_m() const;
};

/// Distance [m] from the hull to a point in the base frame; 0 inside.
[[nodiscard]] double distance_to(const Hull& hull, const Eigen::Vector2d& point_in_base);

/// How far the base can drive [m] along the arc of `curvature` [1/m, left positive] until the hull touches the point.
///
/// 0 if it does now, infinite if it never will. The point turns around the arc's centre as seen from the base, so the
/// answer is the smallest turn that brings it onto the hull's edge: exact, without stepping along the arc.
[[nodiscard]] double way_to_contact(const Hull& hull, double curvature, const Eigen::Vector2d& point_in_base);

/// The free way [m] along an arc and what ends it.
struct FreeWay {
  double way_m = 0.0;
  Eigen::Vector2d obstacle_in_base{0.0, 0.0};  ///< Only if way_m is finite.
};

/// The free way of the hull with `margin_m` on all sides. A point that is within the margin already counts with what
/// margin is left, so that one can drive away from it and along it, but never into it.
[[nodiscard]] FreeWay free_way(const Hull& hull, double margin_m, double curvature,
                               const std::vector<Eigen::Vector2d>& points_in_base);

/// The greatest speed [m/s] from which the robot comes to rest within `way_m`: v t + v^2 / (2 a) = way_m.
[[nodiscard]] double speed_that_stops_within(double way_m, double reaction_time_s, double deceleration_mps2);

/// The pose after `way_m` along an arc, seen from its start.
[[nodiscard]] Pose2 start_from_end(double curvature, double way_m);

}  // namespace tandem::navigator
