#pragma once

#include <Eigen/Core>
#include <vector>

#include "services/planner/core/srs/planar_shape.hpp"

namespace tandem {

// Segments, circles and what a straight way meets of them. A share is a place on a way: 0 its start, 1 its end.

[[nodiscard]] inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Positive if the corners go counter-clockwise [m2].
[[nodiscard]] double twice_signed_area(const std::vector<Eigen::Vector2d>& corners);

[[nodiscard]] Eigen::Vector2d nearest_on_segment(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                                 const Eigen::Vector2d& point);

/// Of all points within `radius_m` of the segment; the depth is measured from the segment.
[[nodiscard]] BoundaryVector vector_from_capsule(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double radius_m,
                                                 const Eigen::Vector2d& point);

/// Whether two closed segments have a point in common.
[[nodiscard]] bool segments_meet(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                                 const Eigen::Vector2d& d);

/// Whether two segments that share an end have more than that in common: they lie on each other.
[[nodiscard]] bool fold_back(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                             const Eigen::Vector2d& d);

/// Appends the share if it lies in [0, 1].
void append_share(double share, std::vector<double>& shares);

/// Where a*s^2 + 2*half_b*s + c = 0 in [0, 1]: the squared distance to a round thing less its squared radius [m2].
/// Nothing where it only touches.
void append_quadratic_roots(double a, double half_b, double c, std::vector<double>& shares);

/// Where the way meets the circle; nothing if the radius is negative.
void append_circle_crossings(const Eigen::Vector2d& centre, double radius_m, const Eigen::Vector2d& from,
                             const Eigen::Vector2d& to, std::vector<double>& shares);

/// Where the way is `radius_m` away from the segment; nothing if the radius is negative.
void append_capsule_crossings(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double radius_m,
                              const Eigen::Vector2d& from, const Eigen::Vector2d& to, std::vector<double>& shares);

}  // namespace tandem
