#pragma once

#include <memory>
#include <string>
#include <vector>

#include "services/mapping/core/map_areas.hpp"
#include "services/planner/core/planner_config.hpp"
#include "services/planner/core/team/search_world.hpp"

namespace tandem {

/// What `config` says of a search by `robot`, searcher 0, and `person`, searcher 1. `start_in_map` is where the robot
/// is when the search is prepared [m].
[[nodiscard]] SearchWorldOptions search_world_options(const PlannerConfig& config, const std::string& robot,
                                                      const std::string& person, const Eigen::Vector2d& start_in_map);

/// The world of that search on `map`. The robot, searcher 0, keeps out of the areas that say so, and sees across them;
/// nobody else minds them.
[[nodiscard]] std::unique_ptr<SearchWorld> search_world(const OccupancyGrid& map, const std::vector<MapArea>& zones,
                                                        SearchWorldOptions options);

}  // namespace tandem
