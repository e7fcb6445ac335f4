#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "services/common/angle.hpp"
#include "services/common/pose2.hpp"

namespace tandem {

/// Poses around a centre: a square whose sides lie along the map's grid, and a turn each way.
struct PoseArea {
  Pose2 centre_in_map;
  double half_side_m = 0.0;
  double half_turn_rad = 0.0;
};

/// The lattice positions and headings of an area; without one, all there are.
class SearchLimits {
 public:
  SearchLimits() = default;
  SearchLimits(const std::optional<PoseArea>& area, const Pose2& grid_from_map, double step_m) {
    if (!area) return;
    const Pose2 centre = grid_from_map * area->centre_in_map;
    const auto lattice = [step_m](double at_m) {
      return static_cast<int>(std::floor(std::clamp(at_m / step_m, -1e6, 1e6)));
    };
    first_column_ = lattice(centre.x - area->half_side_m);
    first_row_ = lattice(centre.y - area->half_side_m);
    last_column_ = lattice(centre.x + area->half_side_m);
    last_row_ = lattice(centre.y + area->half_side_m);
    heading_rad_ = centre.heading;
    half_turn_rad_ = area->half_turn_rad;
  }

  /// Whether a box of positions, `side` steps wide, has any of them.
  [[nodiscard]] bool meets(int column, int row, int side) const {
    return column <= last_column_ && row <= last_row_ && column + side > first_column_ && row + side > first_row_;
  }
  [[nodiscard]] bool has_heading(double heading_rad) const {
    return std::abs(turn_between(heading_rad_, heading_rad)) <= half_turn_rad_;
  }

 private:
  int first_column_ = 0;
  int first_row_ = 0;
  int last_column_ = std::numeric_limits<int>::max();
  int last_row_ = std::numeric_limits<int>::max();
  double heading_rad_ = 0.0;
  double half_turn_rad_ = std::numeric_limits<double>::infinity();
};

}  // namespace tandem
