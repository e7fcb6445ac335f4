#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robot/safety/core/hard_zones.hpp"

namespace tandem {

/// The hard zones of a map.
struct MapZones {
  std::vector<safety::HardZone> zones;
  std::string map_sha256;  ///< Of the map they belong to; empty where there are none, and any map will do.
};

/// The areas with a rule in areas.json beside `map_yaml`; none for an empty path or where there is no such file. Throws
/// ConfigError or FileError on a bad file, MapError where there are zones but no map.
[[nodiscard]] MapZones load_map_zones(const std::filesystem::path& map_yaml);

}  // namespace tandem
