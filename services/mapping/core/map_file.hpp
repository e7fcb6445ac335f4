#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem {

/// A map that cannot be used; what() says file, line and what is wrong.
class MapError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Larger maps are refused before anything is allocated for them.
inline constexpr std::int64_t kDefaultMaxCells = 64'000'000;

/// The map of a ROS map_server YAML file and the PGM or PNG image it names (relative to the YAML file).
///
/// A pixel's occupancy is (255 - value) / 255, or value / 255 with `negate`; above occupied_thresh it is occupied,
/// below free_thresh free, else unknown. The image's last row is the grid's first. Throws MapError.
[[nodiscard]] OccupancyGrid load_map(const std::filesystem::path& yaml_file, std::int64_t max_cells = kDefaultMaxCells);

/// Writes `grid` as `yaml_file` and a PGM beside it with the same stem; load_map gives the same grid back.
/// Throws FileError.
void save_map(const OccupancyGrid& grid, const std::filesystem::path& yaml_file);

/// The name other services know a map file by: its stem.
[[nodiscard]] std::string map_id_of(const std::filesystem::path& yaml_file);

/// SHA-256 over the cells, row by row from the lower left, as 64 hex digits.
[[nodiscard]] std::string sha256_of_cells(const OccupancyGrid& grid);

}  // namespace tandem
