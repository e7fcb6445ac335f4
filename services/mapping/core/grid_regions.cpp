#include "services/mapping/core/grid_regions.hpp"

#include <algorithm>
#include <array>

namespace tandem {
namespace {

constexpr std::array<CellIndex, 4> kSides{CellIndex{1, 0}, CellIndex{0, 1}, CellIndex{-1, 0}, CellIndex{0, -1}};

GridRegion flooded(const OccupancyGrid& grid, CellIndex start, std::vector<bool>& seen) {
  GridRegion region{.state = grid.at(start), .first = start, .lowest = start, .highest = start};
  std::vector<CellIndex> open{start};
  seen[grid.offset(start)] = true;
  while (!open.empty()) {
    const CellIndex cell = open.back();
    open.pop_back();
    ++region.cells;
    region.lowest = {std::min(region.lowest.column, cell.column), std::min(region.lowest.row, cell.row)};
    region.highest = {std::max(region.highest.column, cell.column), std::max(region.highest.row, cell.row)};
    for (const CellIndex& side : kSides) {
      const CellIndex next{cell.column + side.column, cell.row + side.row};
      if (!grid.contains(next)) {
        region.at_border = true;
        continue;
      }
      if (grid.is_free(next)) ++region.free_sides;
      if (grid.at(next) != region.state || seen[grid.offset(next)]) continue;
      seen[grid.offset(next)] = true;
      open.push_back(next);
    }
  }
  return region;
}

}  // namespace

std::vector<GridRegion> regions_of(const OccupancyGrid& grid) {
  std::vector<GridRegion> regions;
  std::vector<bool> seen(grid.cells().size());
  for (int row = 0; row < grid.height(); ++row) {
    for (int column = 0; column < grid.width(); ++column) {
      if (!seen[grid.offset({column, row})]) regions.push_back(flooded(grid, {column, row}, seen));
    }
  }
  return regions;
}

}  // namespace tandem
