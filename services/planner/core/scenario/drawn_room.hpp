#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem {

/// A wall along a polyline.
struct RoomWall {
  std::vector<Eigen::Vector2d> points_in_map;  ///< [m], at least two
  double thickness_m = 0.2;
  double height_m = std::numeric_limits<double>::infinity();  ///< What flies higher passes over it.
};

/// A solid rectangle along the axes.
struct RoomBox {
  Eigen::Vector2d min_in_map;  ///< [m]
  Eigen::Vector2d max_in_map;  ///< [m]
  double height_m = std::numeric_limits<double>::infinity();
};

/// A rectangular room within walls that nothing flies over; its inner lower left corner is the map's origin.
struct DrawnRoom {
  double width_m = 10.0;  ///< inner size along x
  double height_m = 10.0;
  double resolution_m = 0.1;
  std::vector<RoomWall> walls;
  std::vector<RoomBox> boxes;
};

/// The room for who moves `altitude_m` above the floor: what is lower does not stand in the way. A cell takes what its
/// centre lies in.
[[nodiscard]] OccupancyGrid draw_layer(const DrawnRoom& room, double altitude_m);

}  // namespace tandem
