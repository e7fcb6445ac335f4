#include "services/planner/core/srs/search_sources.hpp"

#include <utility>

namespace tandem {

RewardSource search_cell_source(const std::string& id, const Boundary& visible_from, double joint_mass,
                                double detection_rate_per_s) {
  RewardSource source;
  source.id = id;
  source.meaning = "the object may lie here";
  source.boundary = visible_from;
  source.flow = Flow::Proportional;
  source.rate_per_s = detection_rate_per_s;
  source.pool = joint_mass;
  return source;
}

RewardSource found_event() {
  RewardSource source;
  source.id = kFoundId;
  source.meaning = "the object is found";
  source.boundary = Disc{};
  source.pool = 1.0;
  return source;
}

RewardSource goal_source(const std::string& agent, const Eigen::Vector2d& point_in_map, double reach_m) {
  RewardSource source;
  source.id = "goal_" + agent;
  source.meaning = agent + " is asked to go here";
  source.boundary = Disc{point_in_map, reach_m};
  source.rate_per_s = 1.0;
  source.pool = 1.0;
  source.targets = {agent};
  return source;
}

RewardWorld search_world(std::vector<RewardSource> cells) {
  RewardWorld world;
  for (const auto& cell : cells) world.relations.push_back({RelationKind::Soft, cell.id, kFoundId, 1.0, {}});
  world.sources = std::move(cells);
  world.sources.push_back(found_event());
  return world;
}

}  // namespace tandem
