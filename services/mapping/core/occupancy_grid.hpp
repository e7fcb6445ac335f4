#pragma once

#include <Eigen/Core>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "services/common/pose2.hpp"

namespace tandem {

/// What is known of a cell; the values are those of msg::OccupancyGrid.
enum class CellState : std::uint8_t { Free = 0, Occupied = 100, Unknown = 255 };

/// A cell of a grid: columns run along the grid's x axis, rows along its y axis, both from the lower left.
struct CellIndex {
  int column = 0;
  int row = 0;

  friend bool operator==(const CellIndex&, const CellIndex&) = default;
};

/// A map: equal square cells, each free, occupied or unknown; everything outside is unknown.
///
/// A value: copying copies the cells, moving is cheap. Cell (0, 0) has its lower left corner at `map_from_grid()`.
class OccupancyGrid {
 public:
  OccupancyGrid() = default;

  /// A grid of `width` x `height` cells (>= 0) with sides of `resolution_m` (> 0).
  OccupancyGrid(int width, int height, double resolution_m, const Pose2& map_from_grid = {},
                CellState state = CellState::Unknown)
      : width_(width),
        height_(height),
        resolution_m_(resolution_m),
        cells_per_m_(1.0 / resolution_m),
        map_from_grid_(map_from_grid),
        grid_from_map_(inverse(map_from_grid)),
        cosine_(std::cos(grid_from_map_.heading)),
        sine_(std::sin(grid_from_map_.heading)),
        cells_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), state) {
    assert(width >= 0 && height >= 0 && resolution_m > 0.0);
  }

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] bool empty() const { return cells_.empty(); }
  [[nodiscard]] double resolution_m() const { return resolution_m_; }
  [[nodiscard]] const Pose2& map_from_grid() const { return map_from_grid_; }

  /// Row by row from the lower left.
  [[nodiscard]] std::span<const CellState> cells() const { return cells_; }
  [[nodiscard]] std::span<CellState> cells() { return cells_; }

  [[nodiscard]] bool contains(CellIndex cell) const {
    return cell.column >= 0 && cell.row >= 0 && cell.column < width_ && cell.row < height_;
  }
  /// Where `cell` lies in cells(); it must be contained.
  [[nodiscard]] std::size_t offset(CellIndex cell) const {
    assert(contains(cell));
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(cell.column);
  }

  /// Unknown outside the grid.
  [[nodiscard]] CellState at(CellIndex cell) const {
    return contains(cell) ? cells_[offset(cell)] : CellState::Unknown;
  }
  [[nodiscard]] CellState at(const Eigen::Vector2d& point_in_map) const { return at(cell_at(point_in_map)); }
  [[nodiscard]] bool is_free(CellIndex cell) const { return at(cell) == CellState::Free; }
  [[nodiscard]] bool is_occupied(CellIndex cell) const { return at(cell) == CellState::Occupied; }
  /// Changes a contained cell.
  void set(CellIndex cell, CellState state) { cells_[offset(cell)] = state; }

  /// `point_in_map` [m] in cells along the grid's axes: (0, 0) is the lower left corner, (0.5, 0.5) the first centre.
  [[nodiscard]] Eigen::Vector2d in_cells(const Eigen::Vector2d& point_in_map) const {
    return {(grid_from_map_.x + cosine_ * point_in_map.x() - sine_ * point_in_map.y()) * cells_per_m_,
            (grid_from_map_.y + sine_ * point_in_map.x() + cosine_ * point_in_map.y()) * cells_per_m_};
  }
  /// The cell that holds `point_in_map` [m]; perhaps outside the grid. The point must be finite.
  [[nodiscard]] CellIndex cell_at(const Eigen::Vector2d& point_in_map) const {
    const Eigen::Vector2d p = in_cells(point_in_map);
    return {clamped_floor(p.x()), clamped_floor(p.y())};
  }
  /// The centre of `cell` [m].
  [[nodiscard]] Eigen::Vector2d centre_in_map(CellIndex cell) const {
    return map_from_grid_ * Eigen::Vector2d{(cell.column + 0.5) * resolution_m_, (cell.row + 0.5) * resolution_m_};
  }

  friend bool operator==(const OccupancyGrid& a, const OccupancyGrid& b) {
    return a.width_ == b.width_ && a.height_ == b.height_ && a.resolution_m_ == b.resolution_m_ &&
           a.map_from_grid_ == b.map_from_grid_ && a.cells_ == b.cells_;
  }

 private:
  /// A point far outside stays outside instead of overflowing.
  static int clamped_floor(double value) {
    constexpr double kFar = 1e9;
    return static_cast<int>(std::floor(value > kFar ? kFar : (value > -kFar ? value : -kFar)));
  }

  int width_ = 0;
  int height_ = 0;
  double resolution_m_ = 1.0;
  double cells_per_m_ = 1.0;
  Pose2 map_from_grid_;
  Pose2 grid_from_map_;
  double cosine_ = 1.0;
  double sine_ = 0.0;
  std::vector<CellState> cells_;
};

}  // namespace tandem
