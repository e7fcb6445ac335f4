#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem::bench {

/// Where the middle of a body can be: free where the clearance is at least `radius_m`, else occupied.
[[nodiscard]] OccupancyGrid room_for(const OccupancyGrid& map, double radius_m);

/// The corners of what is occupied in `room`, a hair's breadth outside of it [m]: where a shortest way can turn.
[[nodiscard]] std::vector<Eigen::Vector2d> outer_corners(const OccupancyGrid& room);

/// The shortest way between two points over nothing that is occupied in `room`, straight pieces in whatever direction;
/// none if there is no way. Its length is the least there is, but for a hair's breadth (0.1 mm) at each corner.
///
/// A* over the graph of corners that see each other.
[[nodiscard]] std::optional<std::vector<Eigen::Vector2d>> shortest_way(const OccupancyGrid& room,
                                                                       const Eigen::Vector2d& start_in_map,
                                                                       const Eigen::Vector2d& goal_in_map);

/// [m]
[[nodiscard]] double length_m(const std::vector<Eigen::Vector2d>& way);

}  // namespace tandem::bench
