#pragma once

#include <string>
#include <vector>

#include "services/planner/core/tasks/task_planner.hpp"
#include "tests/services/planner/support/sources.hpp"

namespace tandem {

/// Somebody who walks 1 m/s and need not turn.
inline TaskAgent task_agent(const std::string& id, double x, double y) {
  TaskAgent agent;
  agent.searcher.id = id;
  agent.searcher.speed_mps = 1.0;
  agent.searcher.radius_m = 0.2;
  agent.searcher.preferred_clearance_m = 0.2;
  agent.start = {x, y, 0.0};
  return agent;
}

/// A source so small that one has to walk to its point, consumed in an instant.
inline RewardSource spot(const std::string& id, double x, double y, double pool,
                         std::vector<std::string> targets = {}) {
  RewardSource source = disc_source(id, {x, y}, 0.001, pool * 1e4, pool);
  source.targets = std::move(targets);
  return source;
}

/// On an open plane.
inline TaskProblem task_of(std::vector<TaskAgent> agents, std::vector<RewardSource> sources,
                           std::vector<Relation> relations, double horizon_s) {
  TaskProblem problem;
  for (const TaskAgent& agent : agents) problem.world.agents.push_back(agent.searcher.id);
  problem.agents = std::move(agents);
  problem.world.sources = std::move(sources);
  problem.world.relations = std::move(relations);
  problem.horizon_s = horizon_s;
  return problem;
}

/// The ids of the sources an agent visits, in order: "key door".
inline std::string visits_of(const TaskProblem& problem, const TaskPlan& plan, std::size_t agent) {
  std::string ids;
  for (const TaskVisit& visit : plan.agents[agent].visits) {
    ids += (ids.empty() ? "" : " ") + problem.world.sources[visit.source].id;
  }
  return ids;
}

}  // namespace tandem
