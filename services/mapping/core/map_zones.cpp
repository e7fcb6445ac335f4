#include "services/mapping/core/map_zones.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "services/common/config.hpp"
#include "services/mapping/core/map_file.hpp"
#include "services/mapping/core/map_server_config.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

/// Whether a ray to the right crosses the outline an odd number of times.
bool is_inside(const std::vector<Vector2d>& corners, const Vector2d& point) {
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2d from = corners[i] - point;
    const Vector2d to = corners[(i + 1) % corners.size()] - point;
    if ((from.y() > 0.0) == (to.y() > 0.0)) continue;
    if (from.x() - from.y() / (to.y() - from.y()) * (to.x() - from.x()) > 0.0) inside = !inside;
  }
  return inside;
}

double distance_to_segment(const Vector2d& from, const Vector2d& to, const Vector2d& point) {
  const double length2 = (to - from).squaredNorm();
  const double share = length2 > 0.0 ? std::clamp((point - from).dot(to - from) / length2, 0.0, 1.0) : 0.0;
  return (from + share * (to - from) - point).norm();
}

}  // namespace

MapZones load_map_zones(const std::filesystem::path& map_yaml) {
  MapZones found;
  if (map_yaml.empty()) return found;
  found.areas = load_map_areas(map_yaml);
  std::erase_if(found.areas, [](const MapArea& area) { return area.rule == AreaRule::None; });
  if (!found.areas.empty()) found.map_sha256 = sha256_of_cells(load_map(map_yaml));
  return found;
}

MapZones load_zones_of_host(const std::filesystem::path& config_folder) {
  const auto file = config_folder / "map-server.toml";
  if (!std::filesystem::exists(file)) return {};
  return load_map_zones(config_folder / load_config<MapServerConfig>(file).map);
}

double distance_to_area_m(const MapArea& area, const Vector2d& point_in_map) {
  const auto& corners = area.corners_in_map;
  if (is_inside(corners, point_in_map)) return 0.0;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    nearest_m = std::min(nearest_m, distance_to_segment(corners[i], corners[(i + 1) % corners.size()], point_in_map));
  }
  return nearest_m;
}

std::optional<OccupancyGrid> ground_outside(const OccupancyGrid& map, const std::vector<MapArea>& areas,
                                            double margin_m) {
  if (std::ranges::none_of(areas, [](const MapArea& area) { return area.rule == AreaRule::KeepOut; })) {
    return std::nullopt;
  }
  // Of a cell that is touched anywhere the centre may be so far away.
  const double reach_m = margin_m + 0.5 * std::numbers::sqrt2 * map.resolution_m();
  OccupancyGrid ground = map;
  for (const MapArea& area : areas) {
    if (area.rule != AreaRule::KeepOut) continue;
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        const CellIndex cell{x, y};
        if (map.is_free(cell) && distance_to_area_m(area, map.centre_in_map(cell)) <= reach_m) {
          ground.cells()[map.offset(cell)] = CellState::Unknown;
        }
      }
    }
  }
  return ground;
}

}  // namespace tandem
