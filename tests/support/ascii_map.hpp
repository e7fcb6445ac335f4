#pragma once

#include <cassert>
#include <string>
#include <vector>

#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem::test {

/// A room drawn in text, the top row first: `#` wall, `.` free, anything else unknown. All rows are equally long.
///
/// The lower left corner lies at `map_from_grid`.
[[nodiscard]] inline OccupancyGrid ascii_map(const std::vector<std::string>& rows, double resolution_m = 1.0,
                                             const Pose2& map_from_grid = {}) {
  const int height = static_cast<int>(rows.size());
  const int width = rows.empty() ? 0 : static_cast<int>(rows.front().size());
  OccupancyGrid grid{width, height, resolution_m, map_from_grid};
  for (int row = 0; row < height; ++row) {
    const std::string& line = rows[static_cast<std::size_t>(height - 1 - row)];
    assert(static_cast<int>(line.size()) == width);
    for (int column = 0; column < width; ++column) {
      const char mark = line[static_cast<std::size_t>(column)];
      if (mark == '#') grid.set({column, row}, CellState::Occupied);
      if (mark == '.') grid.set({column, row}, CellState::Free);
    }
  }
  return grid;
}

}  // namespace tandem::test
