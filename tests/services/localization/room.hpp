#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "services/localization/core/laser_scan.hpp"
#include "services/mapping/core/ray_casting.hpp"
#include "tests/support/ascii_map.hpp"

namespace tandem::test {

/// A room of 6 m x 4 m that looks different from everywhere, in cells of 0.1 m.
[[nodiscard]] inline OccupancyGrid uneven_room() {
  std::vector<std::string> rows;
  for (int y = 39; y >= 0; --y) {
    std::string row;
    for (int x = 0; x < 60; ++x) {
      const bool border = x == 0 || y == 0 || x == 59 || y == 39;
      const bool cupboard = x < 12 && y > 30;
      const bool pillar = x >= 40 && x < 44 && y >= 10 && y < 14;
      row += border || cupboard || pillar ? '#' : '.';
    }
    rows.push_back(row);
  }
  return ascii_map(rows, 0.1);
}

/// What a laser at the base would measure there: 181 beams, half a turn, without noise.
///
/// A range ends in the middle of the wall's first cell, where the distance field has its zero.
[[nodiscard]] inline LaserScan scan_from(const OccupancyGrid& map, const Pose2& map_from_base, Time time) {
  LaserScan scan{.time = time,
                 .angle_min_rad = -std::numbers::pi / 2.0,
                 .angle_increment_rad = std::numbers::pi / 180.0,
                 .range_min_m = 0.05,
                 .range_max_m = 30.0};
  for (int i = 0; i <= 180; ++i) {
    const double angle = map_from_base.heading + scan.angle_min_rad + i * scan.angle_increment_rad;
    const auto range = range_to_obstacle_m(map, map_from_base.position(), angle, 30.0);
    scan.ranges_m.push_back(range ? static_cast<float>(*range + map.resolution_m() / 2.0)
                                  : std::numeric_limits<float>::quiet_NaN());
  }
  return scan;
}

}  // namespace tandem::test
