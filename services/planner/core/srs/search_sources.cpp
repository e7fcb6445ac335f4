#include "services/planner/core/srs/search_sources.hpp"

#include <limits>
#include <utility>

namespace tandem {

RewardSource search_cell_source(const std::string& id, const Boundary& visible_from, double joint_mass,
                                double detection_rate_per_s) {
  RewardSource source;
  source.id = id;
  source.meaning = "the object may lie here";
  source.boundary = visible_from;
  source.flow = Flow::Proportional;
  source.inside = constant_ratio(detection_rate_per_s);
  source.pool = joint_mass;
  return source;
}

RewardSource found_event() {
  RewardSource source;
  source.id = kFoundId;
  source.meaning = "the object is found";
  source.pool = 1.0;
  return source;
}

RewardSource time_cost_source(const std::string& agent, double cost_per_s) {
  RewardSource source;
  source.id = "time_of_" + agent;
  source.kind = SourceKind::Action;
  source.meaning = "the time of " + agent;
  source.boundary = SpeedInterval{0.0, std::numeric_limits<double>::infinity()};
  source.inside = constant_ratio(-cost_per_s);
  source.targets = {agent};
  return source;
}

RewardSource goal_source(const std::string& agent, const Eigen::Vector2d& point_in_map, double reach_m) {
  RewardSource source;
  source.id = "goal_" + agent;
  source.meaning = agent + " is asked to go here";
  source.boundary = Disc{point_in_map, reach_m};
  source.inside = constant_ratio(1.0);
  source.pool = 1.0;
  source.targets = {agent};
  return source;
}

RewardWorld search_world(std::vector<std::string> agents, std::vector<RewardSource> until_found) {
  RewardWorld world;
  world.agents = std::move(agents);
  for (const auto& source : until_found) {
    Relation relation;
    relation.from = source.id;
    relation.to = kFoundId;
    world.relations.push_back(relation);
  }
  world.sources = std::move(until_found);
  world.sources.push_back(found_event());
  return world;
}

}  // namespace tandem
