#include "bench/planning/instance/floor_plan.hpp"

#include <cmath>
#include <cstddef>

#include "services/mapping/core/distance_field.hpp"

namespace tandem::bench {
namespace {

constexpr int kWallCells = 2;  ///< thickness of the wall around the plan

}  // namespace

OccupancyGrid drawn(const FloorPlan& plan, double altitude_m) {
  const double resolution_m = plan.resolution_m;
  const int width = static_cast<int>(std::lround(plan.width_m / resolution_m)) + 2 * kWallCells;
  const int height = static_cast<int>(std::lround(plan.height_m / resolution_m)) + 2 * kWallCells;
  const double border_m = kWallCells * resolution_m;
  OccupancyGrid grid{width, height, resolution_m, {-border_m, -border_m, 0.0}, CellState::Occupied};
  for (int row = kWallCells; row < height - kWallCells; ++row) {
    for (int column = kWallCells; column < width - kWallCells; ++column) grid.set({column, row}, CellState::Free);
  }
  for (const Box& box : plan.boxes) {
    if (box.height_m <= altitude_m) continue;
    const CellIndex low = grid.cell_at(box.low_in_map + Eigen::Vector2d::Constant(0.5 * resolution_m));
    const CellIndex high = grid.cell_at(box.high_in_map - Eigen::Vector2d::Constant(0.5 * resolution_m));
    for (int row = low.row; row <= high.row; ++row) {
      for (int column = low.column; column <= high.column; ++column) {
        if (grid.contains({column, row})) grid.set({column, row}, CellState::Occupied);
      }
    }
  }
  return grid;
}

double reachable_share(const OccupancyGrid& map, const Eigen::Vector2d& from_in_map, double radius_m) {
  const DistanceField clearance(map, 2.0 * radius_m + 1.0, Obstacles::OccupiedOrUnknown);
  const auto passable = [&](CellIndex cell) { return map.is_free(cell) && clearance.at(cell) >= radius_m; };
  const CellIndex start = map.cell_at(from_in_map);
  if (!map.contains(start) || !passable(start)) return 0.0;
  std::vector<char> visited(map.cells().size(), 0);
  std::vector<CellIndex> open{start};
  visited[map.offset(start)] = 1;
  double reached = 0.0;
  while (!open.empty()) {
    const CellIndex cell = open.back();
    open.pop_back();
    reached += 1.0;
    for (const auto& [columns, rows] : {CellIndex{1, 0}, CellIndex{-1, 0}, CellIndex{0, 1}, CellIndex{0, -1}}) {
      const CellIndex next{cell.column + columns, cell.row + rows};
      if (!map.contains(next) || visited[map.offset(next)] != 0 || !passable(next)) continue;
      visited[map.offset(next)] = 1;
      open.push_back(next);
    }
  }
  double standable = 0.0;
  for (int row = 0; row < map.height(); ++row) {
    for (int column = 0; column < map.width(); ++column) standable += passable({column, row}) ? 1.0 : 0.0;
  }
  return reached / standable;
}

}  // namespace tandem::bench
