#pragma once

#include <Eigen/Core>
#include <variant>
#include <vector>

namespace tandem {

/// All points within `radius_m` of the centre, the circle included.
struct Disc {
  Eigen::Vector2d centre_in_map = Eigen::Vector2d::Zero();  ///< [m]
  double radius_m = 0.0;
};

/// A simple polygon, its edges included; at least three corners.
struct Polygon {
  std::vector<Eigen::Vector2d> corners_in_map;  ///< [m]
};

/// The closed boundary of a reward source: on it is inside (digest B1).
using Boundary = std::variant<Disc, Polygon>;

/// The distance from `point_in_map` to the boundary [m]: positive outside, zero on it, negative inside.
[[nodiscard]] double signed_distance(const Boundary& boundary, const Eigen::Vector2d& point_in_map);

/// Whether the point is inside or on the boundary.
[[nodiscard]] bool contains(const Boundary& boundary, const Eigen::Vector2d& point_in_map);

/// Where the straight way between two points meets the boundary, as shares in [0, 1] of the way, ascending.
[[nodiscard]] std::vector<double> crossings(const Boundary& boundary, const Eigen::Vector2d& from_in_map,
                                            const Eigen::Vector2d& to_in_map);

}  // namespace tandem
