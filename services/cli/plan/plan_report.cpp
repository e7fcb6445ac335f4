#include "services/cli/plan/plan_report.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "services/common/format.hpp"

namespace tandem::cli {
namespace {

using Json = nlohmann::ordered_json;

/// To the millimetre and millisecond: what is beyond tells nobody anything.
double rounded(double value) {
  return std::round(value * 1000.0) / 1000.0;
}

const TaskPlan* task_of(const PlannedScenario& planned) {
  return std::get_if<TaskPlan>(&planned.result);
}

/// The path of an agent from its start on.
TimedPath path_of(const PlanningScenario& scenario, const PlannedScenario& planned, std::size_t agent) {
  const TaskPlan* task = task_of(planned);
  TimedPath path =
      task != nullptr ? task->agents[agent].path : std::get<PlannedSearch>(planned.result).plan.paths[agent];
  if (path.points.empty() || path.points.front().time_s > 0.0) {
    path.points.insert(path.points.begin(), {0.0, scenario.agents[agent].start.position()});
  }
  return path;
}

double length_m(const TimedPath& path) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
    length += (path.points[i + 1].point_in_map - path.points[i].point_in_map).norm();
  }
  return length;
}

Json agents_json(const PlanningScenario& scenario, const PlannedScenario& planned) {
  Json agents = Json::array();
  for (std::size_t a = 0; a < scenario.agents.size(); ++a) {
    Json path = Json::array();
    for (const TimedPoint& point : path_of(scenario, planned, a).points) {
      path.push_back({rounded(point.time_s), rounded(point.point_in_map.x()), rounded(point.point_in_map.y())});
    }
    Json agent{{"id", scenario.agents[a].searcher.id}, {"path", std::move(path)}};
    if (const TaskPlan* task = task_of(planned)) {
      Json visits = Json::array();
      for (const TaskVisit& visit : task->agents[a].visits) {
        visits.push_back({{"source", scenario.world.sources[visit.source].id},
                          {"arrive_s", rounded(visit.arrive_s)},
                          {"leave_s", rounded(visit.leave_s)}});
      }
      agent["visits"] = std::move(visits);
      agent["reward"] = task->agents[a].reward;
      agent["end_s"] = rounded(task->agents[a].end_s);
    }
    agents.push_back(std::move(agent));
  }
  return agents;
}

Json informs_json(const TaskPlan& task) {
  Json informs = Json::array();
  for (const Inform& inform : task.informs) informs.push_back({{"agent", inform.agent}, {"source", inform.source}});
  return informs;
}

Json pools_json(const PlanningScenario& scenario, const TaskPlan& task) {
  Json pools = Json::array();
  for (std::size_t s = 0; s < task.drains.size(); ++s) {
    if (task.drains[s].empty()) continue;
    Json left = Json::array();
    for (const DrainPoint& point : task.drains[s]) left.push_back({rounded(point.time_s), point.left});
    pools.push_back({{"source", scenario.world.sources[s].id}, {"left", std::move(left)}});
  }
  return pools;
}

std::string task_text(const PlanningScenario& scenario, const TaskPlan& task) {
  std::string text = formatted("value %.3f, ", task.value);
  text += task.is_proven() ? "no plan is worth more" : formatted("no plan is worth more than %.3f", task.upper_bound);
  text += formatted("; the last action ends at %.1f s\n", task.makespan_s);
  for (const Inform& inform : task.informs) text += "first tell " + inform.agent + " about " + inform.source + "\n";
  if (!task.informs.empty()) text += formatted("without a message the best value is %.3f\n", task.value_untold);
  text += formatted("\n%-16s %-20s %9s %9s %9s\n", "agent", "source", "arrives s", "leaves s", "reward");
  for (std::size_t a = 0; a < task.agents.size(); ++a) {
    const TaskAgentPlan& agent = task.agents[a];
    text += formatted("%-16s %-20s %9s %9.1f %9.3f\n", scenario.agents[a].searcher.id.c_str(), "", "", agent.end_s,
                      agent.reward);
    for (const TaskVisit& visit : agent.visits) {
      text += formatted("%-16s %-20s %9.1f %9.1f\n", "", scenario.world.sources[visit.source].id.c_str(),
                        visit.arrive_s, visit.leave_s);
    }
  }
  return text;
}

std::string search_text(const PlanningScenario& scenario, const PlannedScenario& planned) {
  const auto& search = std::get<PlannedSearch>(planned.result);
  const JointPlan& plan = search.plan;
  std::string text =
      formatted("expected time to find %.1f s; found within %.0f s: %.1f %%; ", plan.forecast.expected_time_s,
                scenario.horizon_s, 100.0 * plan.forecast.probability_found);
  text += search.lower_bound_s > 0.0 ? formatted("no plan takes less than %.1f s\n", search.lower_bound_s)
                                     : "no lower bound is known\n";
  text += formatted("\n%-16s %9s %9s %9s   %s\n", "agent", "ends s", "way m", "corners", "ends at");
  for (std::size_t a = 0; a < scenario.agents.size(); ++a) {
    const TimedPath path = path_of(scenario, planned, a);
    const Eigen::Vector2d& end = path.points.back().point_in_map;
    text += formatted("%-16s %9.1f %9.1f %9zu   %.1f, %.1f\n", scenario.agents[a].searcher.id.c_str(),
                      path.duration_s(), length_m(path), path.points.size(), end.x(), end.y());
  }
  return text;
}

/// What the plan is worth, in a line.
std::string summary_of(const PlanningScenario& scenario, const PlanRequest& request, const PlannedScenario& planned) {
  std::string text = "planner " + request.planner + ": ";
  if (const TaskPlan* task = task_of(planned)) {
    text += formatted("value %.2f", task->value);
    text += task->is_proven() ? " (the best)" : formatted(" (at most %.2f)", task->upper_bound);
    return text + formatted(", done at %.1f s", task->makespan_s);
  }
  const Forecast& forecast = std::get<PlannedSearch>(planned.result).plan.forecast;
  return text + formatted("expected time to find %.1f s, found within %.0f s: %.0f %%", forecast.expected_time_s,
                          scenario.horizon_s, 100.0 * forecast.probability_found);
}

}  // namespace

std::string plan_json(const PlanningScenario& scenario, const PlanRequest& request, const PlannedScenario& planned) {
  const TaskPlan* task = task_of(planned);
  Json json{{"scenario", scenario.name}, {"planner", request.planner}, {"seed", request.seed}};
  if (task != nullptr) {
    json["value"] = task->value;
    for (const char* key : {"expected_time_s", "p_found", "lower_bound_s"}) json[key] = nullptr;
  } else {
    const JointPlan& plan = std::get<PlannedSearch>(planned.result).plan;
    json["value"] = plan.value_s;
    json["expected_time_s"] = plan.forecast.expected_time_s;
    json["p_found"] = plan.forecast.probability_found;
    json["lower_bound_s"] = std::get<PlannedSearch>(planned.result).lower_bound_s;
  }
  json["prepare_ms"] = rounded(planned.prepare_ms);
  json["first_plan_ms"] = rounded(planned.first_plan_ms);
  json["compute_ms"] = rounded(planned.compute_ms);
  json["rollouts"] = planned.rollouts;
  json["role"] = name_of(planned.role);
  json["horizon_s"] = scenario.horizon_s;
  json["agents"] = agents_json(scenario, planned);
  if (task != nullptr) {
    json["informs"] = informs_json(*task);
    json["value_untold"] = task->value_untold;
    json["upper_bound"] = task->upper_bound;
    json["proven"] = task->is_proven();
    json["makespan_s"] = rounded(task->makespan_s);
    json["pools"] = pools_json(scenario, *task);
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string plan_text(const PlanningScenario& scenario, const PlanRequest& request, const PlannedScenario& planned) {
  std::string text = scenario.name + (scenario.description.empty() ? "" : ": " + scenario.description) + "\n";
  text += formatted("planner %s, %lld rollouts; first plan after %.1f ms, all after %.1f ms; role %s\n",
                    request.planner.c_str(), static_cast<long long>(planned.rollouts), planned.first_plan_ms,
                    planned.compute_ms, name_of(planned.role));
  const TaskPlan* task = task_of(planned);
  return text + (task != nullptr ? task_text(scenario, *task) : search_text(scenario, planned));
}

PlanPicture picture_of(const PlanningScenario& scenario, const PlanRequest& request, const PlannedScenario& planned) {
  PlanPicture picture;
  picture.title = scenario.name;
  picture.subtitle =
      (scenario.description.empty() ? "" : scenario.description + " — ") + summary_of(scenario, request, planned);
  picture.layers = layers_of(scenario);
  picture.world = scenario.world;
  const TaskPlan* task = task_of(planned);
  double last_s = 1.0;
  for (std::size_t a = 0; a < scenario.agents.size(); ++a) {
    const ScenarioAgent& agent = scenario.agents[a];
    PicturedAgent pictured{agent.searcher.id, agent.kind, agent.start, path_of(scenario, planned, a), {}};
    if (task != nullptr) pictured.visits = task->agents[a].visits;
    last_s = std::max(last_s, pictured.path.duration_s());
    for (const TaskVisit& visit : pictured.visits) last_s = std::max(last_s, visit.leave_s);
    picture.agents.push_back(std::move(pictured));
  }
  if (task != nullptr) {
    picture.informs = task->informs;
    picture.drains = task->drains;
    picture.end_s = std::min(scenario.horizon_s, std::ceil(1.05 * last_s));
  } else {
    const auto& search = std::get<PlannedSearch>(planned.result);
    picture.belief = search.belief;
    picture.found = search.found;
    picture.found_step_s = kFoundStep_s;
    picture.end_s = scenario.horizon_s;
  }
  return picture;
}

}  // namespace tandem::cli
