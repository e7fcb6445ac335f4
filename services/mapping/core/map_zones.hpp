#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "services/mapping/core/map_areas.hpp"
#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem {

/// The hard zones of a map: its areas with a rule.
struct MapZones {
  std::vector<MapArea> areas;
  std::string map_sha256;  ///< Of the map they belong to; empty where there are none, and any map will do.
};

/// Those in areas.json beside `map_yaml`; none for an empty path or where there is no such file. Throws ConfigError or
/// FileError on a bad file, MapError where there are zones but no map.
[[nodiscard]] MapZones load_map_zones(const std::filesystem::path& map_yaml);

/// Those of the map that map-server.toml in `config_folder` names, which is the map of this host; none where there is
/// no such file, on a host that gets its map from the other one. Throws as load_map_zones().
[[nodiscard]] MapZones load_zones_of_host(const std::filesystem::path& config_folder);

/// How far `point_in_map` is from the polygon of `area` [m]; 0 on it and inside.
[[nodiscard]] double distance_to_area_m(const MapArea& area, const Eigen::Vector2d& point_in_map);

/// `map` as it is to a robot that keeps out: what is free within `margin_m` of a keep-out area is unknown ground, which
/// it sees across and never goes to. None where nothing keeps it out.
[[nodiscard]] std::optional<OccupancyGrid> ground_outside(const OccupancyGrid& map, const std::vector<MapArea>& areas,
                                                          double margin_m);

}  // namespace tandem
