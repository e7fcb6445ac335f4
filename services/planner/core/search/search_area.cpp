#include "services/planner/core/search/search_area.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "services/mapping/core/distance_field.hpp"
#include "services/planner/core/srs/planar_shape.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr CellIndex kNeighbours[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};

/// Per cell of the map: 0 where a person gets to from the start, more for free floor so many steps further, -1 else.
std::vector<int> steps_from_walked_floor(const OccupancyGrid& map, const SearchAreaOptions& options, int max_steps) {
  const DistanceField clearance(map, 2.0, Obstacles::OccupiedOrUnknown);
  std::vector<int> steps(map.cells().size(), -1);
  const auto walkable = [&](CellIndex cell) {
    return map.is_free(cell) && clearance.at(cell) >= options.walk_clearance_m;
  };
  std::optional<CellIndex> start;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (int row = 0; row < map.height(); ++row) {
    for (int column = 0; column < map.width(); ++column) {
      const double distance_m = (map.centre_in_map({column, row}) - options.start_in_map).norm();
      if (distance_m < nearest_m && walkable({column, row})) {
        nearest_m = distance_m;
        start = CellIndex{column, row};
      }
    }
  }
  if (!start) return steps;
  std::deque<CellIndex> open{*start};
  std::vector<CellIndex> walked;
  steps[map.offset(*start)] = 0;
  while (!open.empty()) {
    const CellIndex cell = open.front();
    open.pop_front();
    walked.push_back(cell);
    for (const auto& [columns, rows] : kNeighbours) {
      const CellIndex next{cell.column + columns, cell.row + rows};
      if (!map.contains(next) || steps[map.offset(next)] >= 0 || !walkable(next)) continue;
      steps[map.offset(next)] = 0;
      open.push_back(next);
    }
  }
  open.assign(walked.begin(), walked.end());
  while (!open.empty()) {
    const CellIndex cell = open.front();
    open.pop_front();
    const int step = steps[map.offset(cell)] + 1;
    if (step > max_steps) continue;
    for (const auto& [columns, rows] : kNeighbours) {
      const CellIndex next{cell.column + columns, cell.row + rows};
      if (!map.is_free(next) || steps[map.offset(next)] >= 0) continue;
      steps[map.offset(next)] = step;
      open.push_back(next);
    }
  }
  return steps;
}

}  // namespace

SearchArea::SearchArea(const OccupancyGrid& map, const SearchAreaOptions& options) : cell_size_m_(options.cell_size_m) {
  const double resolution_m = map.resolution_m();
  const auto steps = steps_from_walked_floor(
      map, options, static_cast<int>(std::ceil((options.walk_clearance_m + 0.1) / resolution_m)));
  const PlanarShape outline = Polygon{options.outline_in_map};
  const auto searched = [&](CellIndex cell) {
    return steps[map.offset(cell)] >= 0 &&
           (options.outline_in_map.empty() || contains(outline, map.centre_in_map(cell)));
  };

  Vector2d low = Vector2d::Constant(std::numeric_limits<double>::infinity());
  Vector2d high = -low;
  for (int row = 0; row < map.height(); ++row) {
    for (int column = 0; column < map.width(); ++column) {
      if (!searched({column, row})) continue;
      low = low.cwiseMin(map.centre_in_map({column, row}));
      high = high.cwiseMax(map.centre_in_map({column, row}));
    }
  }
  if (low.x() > high.x()) return;  // nothing to search
  origin_ = low - Vector2d::Constant(0.5 * resolution_m);
  width_ = static_cast<int>(std::floor((high.x() - origin_.x()) / cell_size_m_)) + 1;
  height_ = static_cast<int>(std::floor((high.y() - origin_.y()) / cell_size_m_)) + 1;

  struct Block {
    int floor_cells = 0;
    double nearest_m = std::numeric_limits<double>::infinity();
    Vector2d point = Vector2d::Zero();
  };
  std::vector<Block> blocks(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (int row = 0; row < map.height(); ++row) {
    for (int column = 0; column < map.width(); ++column) {
      if (!searched({column, row})) continue;
      const Vector2d point = map.centre_in_map({column, row});
      const Vector2d in_cells = (point - origin_) / cell_size_m_;
      const Vector2d block_index = in_cells.array().floor();
      Block& block = blocks[static_cast<std::size_t>(block_index.y()) * static_cast<std::size_t>(width_) +
                            static_cast<std::size_t>(block_index.x())];
      ++block.floor_cells;
      const double from_middle_m = (in_cells - block_index - Vector2d{0.5, 0.5}).norm() * cell_size_m_;
      if (from_middle_m < block.nearest_m) {
        block.nearest_m = from_middle_m;
        block.point = point;
      }
    }
  }
  const double least_floor_m2 = 0.25 * cell_size_m_ * cell_size_m_;
  cell_of_.assign(blocks.size(), -1);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const double floor_m2 = blocks[i].floor_cells * resolution_m * resolution_m;
    if (floor_m2 < least_floor_m2) continue;
    cell_of_[i] = size();
    points_.push_back(blocks[i].point);
    floor_m2_.push_back(floor_m2);
    column_row_.push_back({static_cast<int>(i) % width_, static_cast<int>(i) / width_});
    area_m2_ += floor_m2;
  }
}

int SearchArea::cell_of(int column, int row) const {
  if (column < 0 || row < 0 || column >= width_ || row >= height_) return -1;
  return cell_of_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column)];
}

std::optional<int> SearchArea::cell_at(const Vector2d& point_in_map) const {
  const Vector2d index = ((point_in_map - origin_) / cell_size_m_).array().floor().max(-1.0).min(1e6);
  const int cell = cell_of(static_cast<int>(index.x()), static_cast<int>(index.y()));
  return cell >= 0 ? std::optional{cell} : std::nullopt;
}

std::optional<int> SearchArea::nearest_cell(const Vector2d& point_in_map, double reach_m) const {
  if (const auto cell = cell_at(point_in_map)) return cell;
  std::optional<int> nearest;
  double nearest_m = reach_m;
  for (int cell = 0; cell < size(); ++cell) {
    const double distance_m = (point(cell) - point_in_map).norm();
    if (distance_m <= nearest_m && (!nearest || distance_m < nearest_m)) {
      nearest_m = distance_m;
      nearest = cell;
    }
  }
  return nearest;
}

std::vector<int> SearchArea::cells_around(int cell, double distance_m) const {
  const CellIndex centre = column_row_[static_cast<std::size_t>(cell)];
  const int reach = static_cast<int>(std::ceil(distance_m / cell_size_m_));
  std::vector<int> cells;
  for (int row = centre.row - reach; row <= centre.row + reach; ++row) {
    for (int column = centre.column - reach; column <= centre.column + reach; ++column) {
      const int other = cell_of(column, row);
      if (other >= 0) cells.push_back(other);
    }
  }
  return cells;
}

std::vector<double> uniform_prior(const SearchArea& area, const Vector2d& start_in_map, double excluded_radius_m) {
  std::vector<double> prior(static_cast<std::size_t>(area.size()), 0.0);
  double sum = 0.0;
  for (int cell = 0; cell < area.size(); ++cell) {
    if ((area.point(cell) - start_in_map).norm() < excluded_radius_m) continue;
    prior[static_cast<std::size_t>(cell)] = area.floor_m2(cell);
    sum += area.floor_m2(cell);
  }
  if (sum == 0.0) return excluded_radius_m > 0.0 ? uniform_prior(area, start_in_map, 0.0) : prior;
  for (double& probability : prior) probability /= sum;
  return prior;
}

}  // namespace tandem
