#include "services/planner/core/mission/mission_world.hpp"

#include <utility>

#include "services/mapping/core/map_zones.hpp"

namespace tandem {

SearchWorldOptions search_world_options(const PlannerConfig& config, const std::string& robot,
                                        const std::string& person, const Eigen::Vector2d& start_in_map) {
  SearchWorldOptions options;
  options.area.cell_size_m = config.cell_size_m;
  options.area.walk_clearance_m = config.person_radius_m;
  options.area.start_in_map = start_in_map;
  for (std::size_t i = 0; i + 1 < config.area_in_map_m.size(); i += 2) {
    options.area.outline_in_map.emplace_back(config.area_in_map_m[i], config.area_in_map_m[i + 1]);
  }
  options.searchers = {robot_of(config, robot), person_of(config, person)};
  options.lookout_range_m = {config.robot_lookout_range_m, config.person_lookout_range_m};
  return options;
}

std::unique_ptr<SearchWorld> search_world(const OccupancyGrid& map, const std::vector<MapArea>& zones,
                                          SearchWorldOptions options) {
  constexpr double kMargin_m = 0.1;  // that the safety gate leaves (zone_margin_m)
  std::vector<OccupancyGrid> layers{map};
  if (auto ground = ground_outside(map, zones, kMargin_m)) {
    options.searchers[0].layer = static_cast<int>(layers.size());
    layers.push_back(std::move(*ground));
  }
  return std::make_unique<SearchWorld>(std::move(layers), std::move(options));
}

}  // namespace tandem
