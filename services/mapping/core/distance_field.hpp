#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem {

/// What a distance is measured to.
enum class Obstacles { Occupied, OccupiedOrUnknown };

/// A distance and how it changes with the point.
struct DistanceAndGradient {
  double distance_m = 0.0;
  Eigen::Vector2d gradient_in_map = Eigen::Vector2d::Zero();  ///< [m/m]
};

/// For each cell of a grid the distance [m] from its centre to the centre of the nearest obstacle cell, cut off at
/// `max_distance_m`. Outside the grid the value at the nearest border cell holds.
///
/// Exact Euclidean distances in time linear in the cells (Felzenszwalb and Huttenlocher, Theory of Computing 2012).
class DistanceField {
 public:
  DistanceField() = default;
  explicit DistanceField(const OccupancyGrid& grid, double max_distance_m = std::numeric_limits<double>::infinity(),
                         Obstacles obstacles = Obstacles::Occupied);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] bool empty() const { return distances_m_.empty(); }
  [[nodiscard]] double resolution_m() const { return frame_.resolution_m(); }

  /// Does the grid hold `point_in_map` [m]?
  [[nodiscard]] bool contains(const Eigen::Vector2d& point_in_map) const {
    const CellIndex cell = frame_.cell_at(point_in_map);
    return cell.column >= 0 && cell.row >= 0 && cell.column < width_ && cell.row < height_;
  }
  /// The distance at the centre of `cell`, which is moved to the border if it lies outside.
  [[nodiscard]] float at(CellIndex cell) const {
    const int column = std::clamp(cell.column, 0, width_ - 1);
    const int row = std::clamp(cell.row, 0, height_ - 1);
    return distances_m_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                        static_cast<std::size_t>(column)];
  }
  /// The distance at the centre of the cell that holds `point_in_map` [m]: the fastest answer.
  [[nodiscard]] float nearest(const Eigen::Vector2d& point_in_map) const { return at(frame_.cell_at(point_in_map)); }
  /// Bilinear between cell centres.
  [[nodiscard]] double distance_m(const Eigen::Vector2d& point_in_map) const;
  /// Bicubic (Catmull-Rom) between cell centres: the gradient is continuous, as an optimiser wants it.
  [[nodiscard]] DistanceAndGradient smooth(const Eigen::Vector2d& point_in_map) const;

 private:
  int width_ = 0;
  int height_ = 0;
  OccupancyGrid frame_;  ///< without cells: where the field lies
  std::vector<float> distances_m_;
};

}  // namespace tandem
