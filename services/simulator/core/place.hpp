#pragma once

#include <Eigen/Core>
#include <vector>

#include "services/mapping/core/distance_field.hpp"
#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem::simulator {

/// The ground that everything in the simulation stands on: a map, and how far it is to its walls.
class Place {
 public:
  explicit Place(OccupancyGrid map);

  [[nodiscard]] const OccupancyGrid& map() const { return map_; }
  /// Distance [m] from `point_in_map` to the nearest wall or unknown ground; 0 outside the map.
  [[nodiscard]] double clearance_m(const Eigen::Vector2d& point_in_map) const;
  /// Does a disc of `radius_m` stand freely at `point_in_map`?
  [[nodiscard]] bool has_room(const Eigen::Vector2d& point_in_map, double radius_m) const {
    return clearance_m(point_in_map) >= radius_m;
  }
  /// Can a disc of `radius_m` go straight from one point to the other?
  [[nodiscard]] bool has_way(const Eigen::Vector2d& from_in_map, const Eigen::Vector2d& to_in_map,
                             double radius_m) const;
  /// The centres of the cells of the largest connected ground where a disc of `radius_m` has room, in map order.
  [[nodiscard]] std::vector<Eigen::Vector2d> largest_ground(double radius_m) const;

 private:
  OccupancyGrid map_;
  DistanceField clearance_;
};

/// The shortest walk of a disc of `radius_m` between two points, both ends included: corners [m] joined by straight
/// lines. Empty if there is none. Where an end has no room, it is left (or reached) the direct way.
///
/// A* on a lattice of 0.25 m, then shortened where the straight line is free.
[[nodiscard]] std::vector<Eigen::Vector2d> shortest_walk(const Place& place, const Eigen::Vector2d& from_in_map,
                                                         const Eigen::Vector2d& to_in_map, double radius_m);

}  // namespace tandem::simulator
