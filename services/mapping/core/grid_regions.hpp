#pragma once

#include <cstddef>
#include <vector>

#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem {

/// Cells of one state that hang together over their sides.
struct GridRegion {
  CellState state{};
  std::size_t cells = 0;
  CellIndex first;             ///< its first cell, row by row from the lower left
  CellIndex lowest;            ///< corner of its bounding box
  CellIndex highest;           ///< the other corner, within
  bool at_border = false;      ///< touches the edge of the grid
  std::size_t free_sides = 0;  ///< sides that it shares with free cells
};

/// All regions of a grid, by their first cell.
[[nodiscard]] std::vector<GridRegion> regions_of(const OccupancyGrid& grid);

}  // namespace tandem
