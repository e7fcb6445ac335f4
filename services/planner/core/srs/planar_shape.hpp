#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace tandem {

// Shapes on the ground. Their points [m] are in the frame of the boundary: the map, or the agent it is attached to.
// All are closed: on the edge is inside.

/// All points within `radius_m` of the centre.
struct Disc {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
  bool operator==(const Disc&) const = default;
};

/// A simple polygon, either way round; at least three corners.
struct Polygon {
  std::vector<Eigen::Vector2d> corners;
  bool operator==(const Polygon&) const = default;
};

/// All points within `half_width_m` of a line through the points: a path, a wall, a strip.
struct Corridor {
  std::vector<Eigen::Vector2d> points;
  double half_width_m = 0.0;
  bool operator==(const Corridor&) const = default;
};

/// Everything on one side of the straight line through `point`; `outward` is the direction that leads out of it.
struct HalfPlane {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();
  Eigen::Vector2d outward = Eigen::Vector2d::UnitX();  ///< any length but zero
  bool operator==(const HalfPlane&) const = default;
};

using PlanarShape = std::variant<Disc, Polygon, Corridor, HalfPlane>;

/// The vector from the nearest point of a boundary to a point (digest B1).
struct BoundaryVector {
  double distance = 0.0;  ///< Positive outside, zero on the boundary, negative inside.
  /// Unit vector along it. On the boundary: straight out. Where several points are nearest, that on the +x side of a
  /// disc's centre, to the left of a corridor's middle line, or on the first of a polygon's edges as listed.
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();
};

/// Points nearer to the boundary than this count as on it [m]: crossings are computed, not exact.
inline constexpr double kOnBoundary_m = 1e-9;

/// The depth inside a corridor is measured from its centre line, at bends too.
[[nodiscard]] BoundaryVector vector_to(const PlanarShape& shape, const Eigen::Vector2d& point);

/// The distance alone [m]: positive outside, zero on the boundary, negative inside.
[[nodiscard]] double signed_distance(const PlanarShape& shape, const Eigen::Vector2d& point);

/// Whether the point is inside or on the boundary.
[[nodiscard]] bool contains(const PlanarShape& shape, const Eigen::Vector2d& point);

/// Appends the shares in [0, 1] of the straight way at which its signed distance is `level_m`, in no order: 0 is the
/// boundary itself. Gives false, and appends nothing, where no closed form is known: a polygon at another level than 0.
[[nodiscard]] bool append_level_crossings(const PlanarShape& shape, double level_m, const Eigen::Vector2d& from,
                                          const Eigen::Vector2d& to, std::vector<double>& shares);

/// A disc that holds the shape; none if it has no end.
[[nodiscard]] std::optional<Disc> enclosing_disc(const PlanarShape& shape);

/// The shape in the frame in which its own frame lies at `origin`, turned by `heading_rad`.
[[nodiscard]] PlanarShape moved(const PlanarShape& shape, const Eigen::Vector2d& origin, double heading_rad);

/// A point well inside: the middle of a disc, of a corridor's longest part, some way behind the edge of a half-plane;
/// in a polygon the deepest of the points that a grid over it tries.
[[nodiscard]] Eigen::Vector2d inner_point(const PlanarShape& shape);

/// What is degenerate about the shape, for people; none if nothing is.
[[nodiscard]] std::optional<std::string> problem_of(const PlanarShape& shape);

}  // namespace tandem
