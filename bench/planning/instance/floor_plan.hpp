#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem::bench {

/// An upright box that stands on the floor: a wall, a column, a shelf.
struct Box {
  Eigen::Vector2d low_in_map;   ///< lower left corner [m]
  Eigen::Vector2d high_in_map;  ///< upper right corner [m]
  double height_m = std::numeric_limits<double>::infinity();
};

/// A rectangle of floor with one corner at the origin of the map frame, and what stands on it. A wall surrounds it.
struct FloorPlan {
  double width_m = 0.0;
  double height_m = 0.0;
  double resolution_m = 0.1;
  std::vector<Box> boxes;
};

/// The plan as a map of what is in the way `altitude_m` above the floor, at 0 everything.
[[nodiscard]] OccupancyGrid drawn(const FloorPlan& plan, double altitude_m);

/// The share of the free floor that a body of `radius_m` can be moved to from `from_in_map`, 0 if it cannot stand
/// there.
[[nodiscard]] double reachable_share(const OccupancyGrid& map, const Eigen::Vector2d& from_in_map, double radius_m);

}  // namespace tandem::bench
