#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem {

/// What part of a map is searched.
struct SearchAreaOptions {
  double cell_size_m = 0.5;
  double walk_clearance_m = 0.25;                          ///< A person gets through where this is free to both sides.
  Eigen::Vector2d start_in_map = Eigen::Vector2d::Zero();  ///< Only what can be walked to from here [m].
  std::vector<Eigen::Vector2d> outline_in_map;             ///< A polygon that limits the area; empty: none.
};

/// The floor where the object may lie, in square cells: whatever a person can get at from the start.
///
/// Cells are numbered 0 .. size() - 1, row by row; the grid of columns and rows around them lies along the map's axes.
class SearchArea {
 public:
  SearchArea(const OccupancyGrid& map, const SearchAreaOptions& options);

  [[nodiscard]] int size() const { return static_cast<int>(points_.size()); }
  [[nodiscard]] double area_m2() const { return area_m2_; }
  [[nodiscard]] double cell_size_m() const { return cell_size_m_; }
  /// A free point of the cell near its middle [m]: where the object is taken to lie, and where one looks from.
  [[nodiscard]] const Eigen::Vector2d& point(int cell) const { return points_[static_cast<std::size_t>(cell)]; }
  /// The free floor of the cell [m2].
  [[nodiscard]] double floor_m2(int cell) const { return floor_m2_[static_cast<std::size_t>(cell)]; }
  [[nodiscard]] std::optional<int> cell_at(const Eigen::Vector2d& point_in_map) const;
  /// The cell at the point, or the nearest one within `reach_m`.
  [[nodiscard]] std::optional<int> nearest_cell(const Eigen::Vector2d& point_in_map, double reach_m) const;
  /// Cells whose column and row lie within `distance_m` of those of `cell`.
  [[nodiscard]] std::vector<int> cells_around(int cell, double distance_m) const;

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] const Eigen::Vector2d& origin_in_map() const { return origin_; }
  /// The cell at a column and row, -1 if nothing is searched there.
  [[nodiscard]] int cell_of(int column, int row) const;

 private:
  double cell_size_m_ = 0.5;
  double area_m2_ = 0.0;
  int width_ = 0;
  int height_ = 0;
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
  std::vector<int> cell_of_;
  std::vector<CellIndex> column_row_;
  std::vector<Eigen::Vector2d> points_;
  std::vector<double> floor_m2_;
};

/// A uniform prior over the floor: the probability of each cell, in all 1. Nothing within `excluded_radius_m` of
/// `start_in_map`, unless that leaves nothing at all (digest G5).
[[nodiscard]] std::vector<double> uniform_prior(const SearchArea& area, const Eigen::Vector2d& start_in_map,
                                                double excluded_radius_m);

}  // namespace tandem
