#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tandem {

/// What the robot must do about an area, whoever tells it what.
enum class AreaRule {
  None,     ///< It only has a name.
  KeepOut,  ///< The hull never enters.
  Slow,     ///< The hull enters and crosses it no faster than max_speed_mps.
};

/// A named polygon of a map.
struct MapArea {
  std::string name;
  std::vector<Eigen::Vector2d> corners_in_map;  ///< At least three [m].
  AreaRule rule = AreaRule::None;
  double max_speed_mps = 0.0;  ///< Of a slow area.
};

/// The areas in `json`, an object of names: {"kitchen": [[0, 0], [4, 0], [4, 3]],
/// "stairs": {"corners": [...], "rule": "keep_out"}, "ramp": {"corners": [...], "rule": "slow", "max_speed_mps": 0.2}}.
/// `file_name` stands in messages. Throws ConfigError with file and name.
[[nodiscard]] std::vector<MapArea> parse_map_areas(std::string_view json, const std::string& file_name);

/// The areas in areas.json in the folder of the map; none if there is no such file. Throws ConfigError or FileError.
[[nodiscard]] std::vector<MapArea> load_map_areas(const std::filesystem::path& map_yaml);

}  // namespace tandem
