#pragma once

#include <string>
#include <vector>

#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem {

/// A room drawn in ASCII, first line at the top: '#' wall, '.' free; each sign is `sign_m` wide and high, in map cells
/// of 0.1 m. The lower left corner is the map's origin.
inline OccupancyGrid room(const std::vector<std::string>& drawing, double sign_m = 0.5) {
  constexpr double kResolution_m = 0.1;
  const int cells = static_cast<int>(sign_m / kResolution_m + 0.5);
  const int rows = static_cast<int>(drawing.size());
  const int columns = static_cast<int>(drawing.front().size());
  OccupancyGrid grid(columns * cells, rows * cells, kResolution_m, {}, CellState::Free);
  for (int row = 0; row < grid.height(); ++row) {
    for (int column = 0; column < grid.width(); ++column) {
      const char sign =
          drawing[static_cast<std::size_t>(rows - 1 - row / cells)][static_cast<std::size_t>(column / cells)];
      if (sign == '#') grid.set({column, row}, CellState::Occupied);
    }
  }
  return grid;
}

/// An empty room of the given inner size [m] within walls of 0.5 m.
inline OccupancyGrid empty_room(int width_m, int height_m) {
  const std::string wall(static_cast<std::size_t>(2 * width_m + 2), '#');
  const std::string floor = "#" + std::string(static_cast<std::size_t>(2 * width_m), '.') + "#";
  std::vector<std::string> drawing(static_cast<std::size_t>(2 * height_m), floor);
  drawing.insert(drawing.begin(), wall);
  drawing.push_back(wall);
  return room(drawing);
}

}  // namespace tandem
