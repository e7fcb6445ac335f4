#pragma once

#include <Eigen/Core>
#include <vector>

namespace tandem::navigator {

/// A path as straight pieces between points of the map, measured by the way from its start.
class Path {
 public:
  Path() = default;
  /// Points that coincide with the one before (less than 1 mm apart) are dropped.
  explicit Path(const std::vector<Eigen::Vector2d>& points_in_map);

  [[nodiscard]] bool empty() const { return points_.empty(); }
  [[nodiscard]] double length_m() const { return way_m_.empty() ? 0.0 : way_m_.back(); }
  [[nodiscard]] const Eigen::Vector2d& goal() const { return points_.back(); }

  /// The point after `way_m` [m] of the path; its ends beyond them. The path must not be empty.
  [[nodiscard]] Eigen::Vector2d point_at(double way_m) const;

  /// A place on the path: how far along and how far away from what was asked about.
  struct Place {
    double way_m = 0.0;
    double distance_m = 0.0;
  };
  /// The place closest to `point_in_map` among those from `first_m` to `last_m` [m].
  ///
  /// `preference` is added for each metre of way from `first_m`: where a path comes by twice, the earlier time counts.
  [[nodiscard]] Place nearest(const Eigen::Vector2d& point_in_map, double first_m, double last_m,
                              double preference = 0.0) const;

  friend bool operator==(const Path&, const Path&) = default;

 private:
  std::vector<Eigen::Vector2d> points_;
  std::vector<double> way_m_;  ///< of each point, from the start
};

}  // namespace tandem::navigator
