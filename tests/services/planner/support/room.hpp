#pragma once

#include <string>
#include <vector>

#include "tests/support/ascii_map.hpp"

namespace tandem {

/// A room drawn in ASCII, first line at the top: '#' wall, '.' free; each sign is `sign_m` wide and high, in map cells
/// of 0.1 m. The lower left corner is the map's origin.
inline OccupancyGrid room(const std::vector<std::string>& drawing, double sign_m = 0.5) {
  constexpr double kResolution_m = 0.1;
  const auto cells = static_cast<std::size_t>(sign_m / kResolution_m + 0.5);
  std::vector<std::string> rows;
  for (const std::string& line : drawing) {
    std::string row;
    for (const char sign : line) row.append(cells, sign);
    rows.insert(rows.end(), cells, row);
  }
  return test::ascii_map(rows, kResolution_m);
}

/// An empty room of the given inner size [m] within walls of 0.5 m.
inline OccupancyGrid empty_room(int width_m, int height_m) {
  const std::string wall(static_cast<std::size_t>(2 * width_m + 2), '#');
  const std::string floor = "#" + std::string(static_cast<std::size_t>(2 * width_m), '.') + "#";
  std::vector<std::string> drawing(static_cast<std::size_t>(2 * height_m), floor);
  drawing.insert(drawing.begin(), wall);
  drawing.push_back(wall);
  return room(drawing);
}

}  // namespace tandem
