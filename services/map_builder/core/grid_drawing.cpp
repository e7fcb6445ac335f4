#include "services/map_builder/core/grid_drawing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "services/mapping/core/grid_axis.hpp"
#include "services/mapping/core/map_file.hpp"

namespace tandem {
namespace {

/// How often beams ended in a cell, and how often they went through.
struct CellCount {
  std::uint16_t hits = 0;
  std::uint16_t passes = 0;
};

void add_one(std::uint16_t& count) {
  if (count < std::numeric_limits<std::uint16_t>::max()) ++count;
}

/// Cells as large as the map, all unknown.
OccupancyGrid frame_around(std::span<const MapScan> scans, std::span<const Pose2> poses,
                           const MapBuilderConfig& config) {
  Eigen::AlignedBox2d box;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    box.extend(poses[i] * scans[i].laser_in_base);
    for (const Eigen::Vector2d& endpoint : scans[i].endpoints_in_base) box.extend(poses[i] * endpoint);
  }
  if (box.isEmpty()) return {};
  const double cell_m = config.resolution_m;
  // Whole cells from the origin on, so that cells lie alike whatever is seen at the rim.
  const Eigen::Array2d low = ((box.min().array() - config.margin_m) / cell_m).floor();
  const Eigen::Array2d high = ((box.max().array() + config.margin_m) / cell_m).ceil();
  const Eigen::Array2d cells = high - low;
  if (cells.prod() > static_cast<double>(kDefaultMaxCells)) {
    throw MapError{"the map would be " + std::to_string(std::lround(cells.x() * cell_m)) + " x " +
                   std::to_string(std::lround(cells.y() * cell_m)) + " m, more than " +
                   std::to_string(kDefaultMaxCells) + " cells; choose a larger resolution_m"};
  }
  return {static_cast<int>(high.x() - low.x()),
          static_cast<int>(high.y() - low.y()),
          cell_m,
          {low.x() * cell_m, low.y() * cell_m, 0.0}};
}

/// Counts a beam, both ends in cells of the grid.
void count_beam(const OccupancyGrid& grid, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                std::vector<CellCount>& counts) {
  const CellIndex end{static_cast<int>(std::floor(to.x())), static_cast<int>(std::floor(to.y()))};
  const double length = (to - from).norm();
  const Eigen::Vector2d direction = length > 0.0 ? Eigen::Vector2d{(to - from) / length} : Eigen::Vector2d::UnitX();
  GridAxis column{from.x(), direction.x(), static_cast<int>(std::floor(from.x()))};
  GridAxis row{from.y(), direction.y(), static_cast<int>(std::floor(from.y()))};
  while (column.cell != end.column || row.cell != end.row) {
    add_one(counts[grid.offset({column.cell, row.cell})].passes);
    GridAxis& nearer = column.next < row.next ? column : row;
    if (nearer.next > length) break;  // rounding: the end is the cell beside
    nearer.advance();
    if (!grid.contains({column.cell, row.cell})) break;
  }
  add_one(counts[grid.offset(end)].hits);
}

}  // namespace

OccupancyGrid drawn_grid(std::span<const MapScan> scans, std::span<const Pose2> poses, const MapBuilderConfig& config,
                         const std::function<bool(double)>& keep_going) {
  OccupancyGrid grid = frame_around(scans, poses, config);
  std::vector<CellCount> counts(grid.cells().size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!keep_going(static_cast<double>(i) / static_cast<double>(poses.size()))) break;
    const Eigen::Vector2d from = grid.in_cells(poses[i] * scans[i].laser_in_base);
    for (const Eigen::Vector2d& endpoint : scans[i].endpoints_in_base) {
      count_beam(grid, from, grid.in_cells(poses[i] * endpoint), counts);
    }
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const int all = counts[i].hits + counts[i].passes;
    if (all == 0) continue;
    grid.cells()[i] = counts[i].hits >= config.occupied_share * all ? CellState::Occupied : CellState::Free;
  }
  return grid;
}

}  // namespace tandem
