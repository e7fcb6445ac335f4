#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem::simulator {

/// A wall of a plan: a straight piece of the given thickness.
struct PlanWall {
  Eigen::Vector2d from;  ///< [m]
  Eigen::Vector2d to;    ///< [m]
  double thickness_m = 0.2;
};

/// A solid rectangle along the axes: a block, or one column.
struct PlanBlock {
  Eigen::Vector2d min;  ///< [m]
  Eigen::Vector2d max;  ///< [m]
};

/// A place as an architect would note it down: a closed outline, free inside, with walls, blocks and columns in it.
struct MapPlan {
  double resolution_m = 0.1;
  double margin_m = 1.0;  ///< Unknown ground around the outline.
  double outline_thickness_m = 0.3;
  std::vector<Eigen::Vector2d> outline;  ///< Corners in order [m]; closes by itself.
  std::vector<PlanWall> walls;
  std::vector<PlanBlock> blocks;  ///< Blocks, and every column of the lattices.
};

/// The plan in `json` (config/maps/*.plan.json). Throws ConfigError with file and key.
[[nodiscard]] MapPlan parse_map_plan(std::string_view json, const std::string& file_name);

/// Draws `plan`: a cell takes what its centre lies in; walls and blocks win over free ground.
[[nodiscard]] OccupancyGrid draw(const MapPlan& plan);

/// How much of `map` is free [m^2].
[[nodiscard]] double free_area_m2(const OccupancyGrid& map);

}  // namespace tandem::simulator
