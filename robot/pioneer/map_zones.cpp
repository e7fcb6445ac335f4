#include "robot/pioneer/map_zones.hpp"

#include <utility>

#include "services/mapping/core/map_areas.hpp"
#include "services/mapping/core/map_file.hpp"

namespace tandem {

MapZones load_map_zones(const std::filesystem::path& map_yaml) {
  MapZones found;
  if (map_yaml.empty()) return found;
  for (auto& area : load_map_areas(map_yaml)) {
    if (area.rule == AreaRule::None) continue;
    const double max_speed_mps = area.rule == AreaRule::Slow ? area.max_speed_mps : 0.0;
    found.zones.push_back({std::move(area.corners_in_map), max_speed_mps});
  }
  if (!found.zones.empty()) found.map_sha256 = sha256_of_cells(load_map(map_yaml));
  return found;
}

}  // namespace tandem
