#include "services/planner/core/mission/team_world.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tandem {
namespace {

SearchAreaOptions area_options(const PlannerConfig& config, const Eigen::Vector2d& start_in_map) {
  SearchAreaOptions options;
  options.cell_size_m = config.cell_size_m;
  options.walk_clearance_m = config.person_radius_m;
  options.start_in_map = start_in_map;
  for (std::size_t i = 0; i + 1 < config.area_in_map_m.size(); i += 2) {
    options.outline_in_map.emplace_back(config.area_in_map_m[i], config.area_in_map_m[i + 1]);
  }
  return options;
}

}  // namespace

TeamWorld::TeamWorld(OccupancyGrid map, const PlannerConfig& config, const std::string& robot,
                     const std::string& person, const Eigen::Vector2d& start_in_map)
    : config_(config),
      map_(std::move(map)),
      area_(map_, area_options(config, start_in_map)),
      observability_(map_, area_, std::max(config.camera_max_m, config.person_view_m)),
      robot_(std::make_unique<ActionSet>(map_, observability_, robot_of(config, robot),
                                         options(config.robot_lookout_range_m), start_in_map)),
      person_(std::make_unique<ActionSet>(map_, observability_, person_of(config, person),
                                          options(config.person_lookout_range_m), start_in_map)) {}

ActionSetOptions TeamWorld::options(double lookout_range_m) const {
  ActionSetOptions options;
  options.step_s = config_.step_s;
  options.lookout_range_m = lookout_range_m;
  return options;
}

void TeamWorld::block(const std::vector<BlockedDisc>& blocked, const Eigen::Vector2d& robot_in_map) {
  robot_ = std::make_unique<ActionSet>(map_, observability_, Searcher{robot_->searcher()},
                                       options(config_.robot_lookout_range_m), robot_in_map, blocked);
}

double TeamWorld::sweep_time_s() const {
  const double half_field_rad = 0.5 * from_degrees(std::min(180.0, config_.camera_field_of_view_deg));
  const double robot_m2ps = 2.0 * config_.camera_max_m * std::sin(half_field_rad) * config_.robot_speed_mps;
  const double person_m2ps = 2.0 * config_.person_view_m * config_.person_speed_mps;
  return area_.area_m2() / (robot_m2ps + person_m2ps);
}

}  // namespace tandem
