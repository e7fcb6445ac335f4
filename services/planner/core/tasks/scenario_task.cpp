#include "services/planner/core/tasks/scenario_task.hpp"

namespace tandem {

TaskProblem task_problem_of(const PlanningScenario& scenario) {
  TaskProblem problem;
  problem.world = scenario.world;
  problem.layers = layers_of(scenario);
  problem.horizon_s = scenario.horizon_s;
  for (const ScenarioAgent& one : scenario.agents) {
    TaskAgent agent;
    agent.searcher = one.searcher;
    agent.start = one.start;
    agent.altitude_m = one.altitude_m;
    agent.goal_in_map = one.goal_in_map;
    if (one.latency_s > 0.0) {
      agent.committed.points = {{0.0, one.start.position()}, {one.latency_s, one.start.position()}};
    }
    problem.agents.push_back(std::move(agent));
  }
  return problem;
}

}  // namespace tandem
