#pragma once

#include <optional>
#include <string>
#include <variant>

#include "services/planner/core/srs/planar_shape.hpp"

namespace tandem {

/// No place at all: an event, such as "the object is found" (digest G6).
struct Nowhere {
  bool operator==(const Nowhere&) const = default;
};

/// An area with a name, of the map or of the world file.
struct NamedArea {
  std::string name;
  Polygon outline;  ///< in the map
  bool operator==(const NamedArea&) const = default;
};

/// A shape that moves and turns with an agent: x ahead of it, y to its left. "Behind me" is a half-plane.
struct Attached {
  std::string agent;
  PlanarShape shape_in_agent;
  bool operator==(const Attached&) const = default;
};

/// An end of a corridor between two things: an agent if it has a name, else a point of the map.
struct Anchor {
  std::string agent;
  Eigen::Vector2d point_in_map = Eigen::Vector2d::Zero();  ///< [m]
  bool operator==(const Anchor&) const = default;
};

/// The corridor between two anchors, straight; it moves and stretches with them.
struct Between {
  Anchor from;
  Anchor to;
  double half_width_m = 0.0;
  bool operator==(const Between&) const = default;
};

/// An interval of speeds: where the sources of an action lie, such as the effort of walking fast.
struct SpeedInterval {
  double min_mps = 0.0;
  double max_mps = 0.0;
  bool operator==(const SpeedInterval&) const = default;
};

/// A ball in space: x and y in the map, z the altitude [m].
struct Sphere {
  Eigen::Vector3d centre_in_map = Eigen::Vector3d::Zero();
  double radius_m = 0.0;
  bool operator==(const Sphere&) const = default;
};

/// A box in space along the map's axes; z is the altitude [m].
struct Box {
  Eigen::Vector3d low_in_map = Eigen::Vector3d::Zero();
  Eigen::Vector3d high_in_map = Eigen::Vector3d::Zero();
  bool operator==(const Box&) const = default;
};

/// The closed boundary of a reward source: on it is inside (digest B1).
using Boundary =
    std::variant<Nowhere, Disc, Polygon, Corridor, HalfPlane, NamedArea, Attached, Between, SpeedInterval, Sphere, Box>;

/// In which space a source lies; it follows from its boundary. A planar one holds at every altitude.
enum class SearchSpace { None, Plane, Volume, Speed };

[[nodiscard]] SearchSpace search_space_of(const Boundary& boundary);

/// The fixed shape on the map that the boundary is; none if it moves or lies in another space.
[[nodiscard]] std::optional<PlanarShape> shape_in_map(const Boundary& boundary);

/// What is degenerate about the boundary, for people; none if nothing is. Whether its agents exist is not asked.
[[nodiscard]] std::optional<std::string> problem_of(const Boundary& boundary);

}  // namespace tandem
