#include "services/mapping/core/ray_casting.hpp"

#include <algorithm>
#include <cmath>

#include "services/mapping/core/grid_axis.hpp"

namespace tandem {
namespace {

/// The part [first, second] of the ray, in cells, that lies within 0 and `size` along one axis; cuts the given one.
void cut_to_grid(double start, double direction, double size, double& first, double& second) {
  if (direction == 0.0) {
    if (start < 0.0 || start >= size) second = -1.0;
    return;
  }
  const double a = (0.0 - start) / direction;
  const double b = (size - start) / direction;
  first = std::max(first, std::min(a, b));
  second = std::min(second, std::max(a, b));
}

/// As range_to_obstacle_m, all in cells.
std::optional<double> length_to_obstacle(const OccupancyGrid& grid, const Eigen::Vector2d& start,
                                         const Eigen::Vector2d& direction, double max_length) {
  double entry = 0.0;
  double exit = max_length;
  cut_to_grid(start.x(), direction.x(), grid.width(), entry, exit);
  cut_to_grid(start.y(), direction.y(), grid.height(), entry, exit);
  if (!(entry <= exit)) return std::nullopt;

  const Eigen::Vector2d inside = start + entry * direction;
  // On the upper border the first cell is the one below it: rounding must not start outside.
  GridAxis column{start.x(), direction.x(), std::clamp(static_cast<int>(std::floor(inside.x())), 0, grid.width() - 1)};
  GridAxis row{start.y(), direction.y(), std::clamp(static_cast<int>(std::floor(inside.y())), 0, grid.height() - 1)};
  const CellState* cells = grid.cells().data();
  const int width = grid.width();
  const int height = grid.height();
  double length = entry;
  while (length <= exit) {
    if (cells[static_cast<std::size_t>(row.cell) * static_cast<std::size_t>(width) +
              static_cast<std::size_t>(column.cell)] == CellState::Occupied) {
      return length;
    }
    GridAxis& nearer = column.next < row.next ? column : row;
    length = std::max(length, nearer.next);
    nearer.advance();
    if (column.cell < 0 || column.cell >= width || row.cell < 0 || row.cell >= height) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> range_to_obstacle_m(const OccupancyGrid& grid, const Eigen::Vector2d& origin_in_map,
                                          double heading_rad, double max_range_m) {
  if (grid.empty()) return std::nullopt;
  const double heading_in_grid = heading_rad - grid.map_from_grid().heading;
  const auto length =
      length_to_obstacle(grid, grid.in_cells(origin_in_map), {std::cos(heading_in_grid), std::sin(heading_in_grid)},
                         max_range_m / grid.resolution_m());
  if (!length) return std::nullopt;
  return *length * grid.resolution_m();
}

bool line_of_sight(const OccupancyGrid& grid, const Eigen::Vector2d& from_in_map, const Eigen::Vector2d& to_in_map) {
  if (grid.empty()) return true;
  const Eigen::Vector2d from = grid.in_cells(from_in_map);
  const Eigen::Vector2d way = grid.in_cells(to_in_map) - from;
  const double length = way.norm();
  if (length == 0.0) return grid.at(from_in_map) != CellState::Occupied;
  return !length_to_obstacle(grid, from, way / length, length).has_value();
}

}  // namespace tandem
