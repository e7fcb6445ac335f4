#pragma once

#include <Eigen/Core>
#include <optional>

#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem {

/// How far a ray from `origin_in_map` [m] towards `heading_rad` (map frame) gets before it enters an occupied cell [m].
///
/// None if it meets none within `max_range_m`. Free and unknown cells, and everything outside the grid, are
/// transparent; 0 if the origin lies in an occupied cell. Walks exactly the cells that the ray crosses (Amanatides and
/// Woo 1987).
[[nodiscard]] std::optional<double> range_to_obstacle_m(const OccupancyGrid& grid, const Eigen::Vector2d& origin_in_map,
                                                        double heading_rad, double max_range_m);

/// Is no occupied cell on the closed straight line between the two points [m]?
[[nodiscard]] bool line_of_sight(const OccupancyGrid& grid, const Eigen::Vector2d& from_in_map,
                                 const Eigen::Vector2d& to_in_map);

}  // namespace tandem
