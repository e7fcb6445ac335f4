#include "services/cli/plan/plan_run.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "services/cli/thread_time.hpp"
#include "services/common/clock.hpp"
#include "services/common/config.hpp"
#include "services/planner/core/tasks/scenario_task.hpp"
#include "services/planner/core/tasks/task_planner.hpp"
#include "services/planner/remote/named_planner.hpp"

namespace tandem::cli {
namespace {

constexpr double kRemoteBudget_ms = 200.0;  ///< told to another program if rollouts are asked for

/// Ends the planning when its time is over, or its rollouts, or the user's patience.
class Budget {
 public:
  Budget(const PlanRequest& request, const std::function<bool(double)>& go_on)
      : request_(request), go_on_(go_on), begin_ms_(thread_cpu_ms()) {}

  [[nodiscard]] double spent_ms() const { return thread_cpu_ms() - begin_ms_; }
  [[nodiscard]] bool is_over(std::int64_t rollouts) const {
    const double share = request_.rollouts ? static_cast<double>(rollouts) /
                                                 static_cast<double>(std::max<std::int64_t>(1, *request_.rollouts))
                                           : spent_ms() / request_.budget_ms;
    return !go_on_(std::min(1.0, share)) || share >= 1.0;
  }

 private:
  const PlanRequest& request_;
  const std::function<bool(double)>& go_on_;
  double begin_ms_;
};

Role role_in(const PlanningScenario& scenario) {
  bool person_goal = false;
  bool robot_goal = false;
  for (const ScenarioAgent& agent : scenario.agents) {
    (agent.kind == ScenarioAgentKind::Person ? person_goal : robot_goal) |= agent.goal_in_map.has_value();
  }
  return role_of(person_goal, robot_goal);
}

SearchMember member_of(const ScenarioAgent& agent, int searcher) {
  SearchMember member;
  member.searcher = searcher;
  member.pose = agent.start;
  member.goal = agent.goal_in_map;
  member.battery_s = agent.searcher.endurance_s;
  if (agent.latency_s > 0.0) {
    member.committed.points = {{0.0, agent.start.position()}, {agent.latency_s, agent.start.position()}};
  }
  return member;
}

PicturedBelief pictured(const SearchArea& area, const std::vector<double>& prior) {
  PicturedBelief belief{area.origin_in_map(), area.cell_size_m(), area.width(), area.height(), {}};
  for (int row = 0; row < area.height(); ++row) {
    for (int column = 0; column < area.width(); ++column) {
      const int cell = area.cell_of(column, row);
      const bool searched = cell >= 0 && area.floor_m2(cell) > 0.0;
      belief.density.push_back(searched ? prior[static_cast<std::size_t>(cell)] / area.floor_m2(cell) : 0.0);
    }
  }
  return belief;
}

void plan_search(const PlanningScenario& scenario, const PlanRequest& request, const std::function<bool(double)>& go_on,
                 PlannedScenario& planned) {
  double before_ms = thread_cpu_ms();
  SearchWorldOptions options;
  options.area.cell_size_m = scenario.search->cell_size_m;
  options.area.start_in_map = scenario.agents.front().start.position();
  for (const ScenarioAgent& agent : scenario.agents) options.searchers.push_back(agent.searcher);
  SearchWorld world{layers_of(scenario), options};
  const SearchArea& area = world.area();
  if (area.size() == 0)
    throw ConfigError("agents: there is no floor to search where the first one starts; start it on free floor");
  SearchProblem problem;
  problem.world = &world;
  for (std::size_t i = 0; i < scenario.agents.size(); ++i) {
    const ScenarioAgent& agent = scenario.agents[i];
    const int searcher = static_cast<int>(i);
    const bool on_floor = world.map(agent.searcher.layer).at(agent.start.position()) == CellState::Free;
    if (!on_floor || !world.actions(searcher).can_stand_near(agent.start.position())) {
      throw ConfigError("agents: " + agent.searcher.id + ": it cannot move where it starts; give it more room");
    }
    problem.members.push_back(member_of(agent, searcher));
  }
  std::vector<Eigen::Vector2d> points;
  std::vector<double> floors_m2;
  for (int cell = 0; cell < area.size(); ++cell) {
    points.push_back(area.point(cell));
    floors_m2.push_back(area.floor_m2(cell));
  }
  const auto prior = prior_of(*scenario.search, options.area.start_in_map, points, floors_m2);
  problem.masses.assign(static_cast<std::size_t>(scenario.search->objects), prior);
  problem.horizon_s = scenario.horizon_s;
  std::vector<int> everybody(scenario.agents.size());
  std::iota(everybody.begin(), everybody.end(), 0);
  problem.tail_s = world.sweep_time_s(everybody);
  while (world.prepare_next() && go_on(0.0)) {
  }
  planned.prepare_ms = thread_cpu_ms() - before_ms;

  const auto planner = named_planner(request.planner, 1e-3 * (request.rollouts ? kRemoteBudget_ms : request.budget_ms));
  // Another program does not count as processor time of this one.
  const SteadyClock clock;
  const Time begin = clock.now();
  const bool elsewhere = is_other_program(request.planner);
  const Budget budget{request, go_on};
  const auto spent_ms = [&] { return elsewhere ? 1e3 * to_seconds(clock.now() - begin) : budget.spent_ms(); };
  planner->begin(problem, Rng{request.seed});
  planned.first_plan_ms = spent_ms();
  const auto most = request.rollouts.value_or(std::numeric_limits<int>::max());
  if (most > 0) planner->run(static_cast<int>(most), [&] { return budget.is_over(planner->rollouts()); });
  PlannedSearch search;
  search.plan = planner->best();
  planned.compute_ms = spent_ms();
  search.lower_bound_s = planner->lower_bound_s();
  planned.rollouts = planner->rollouts();
  search.found = survival_of(problem, search.plan.paths, kFoundStep_s);
  for (double& probability : search.found) probability = 1.0 - probability;
  for (std::size_t m = 0; m < search.plan.paths.size(); ++m) {
    search.plan.paths[m] =
        path_until(search.plan.paths[m], std::min(search.plan.goal_reached_s[m], scenario.horizon_s));
  }
  search.belief = pictured(area, prior);
  planned.result = std::move(search);
}

void plan_team_task(const PlanningScenario& scenario, const PlanRequest& request,
                    const std::function<bool(double)>& go_on, PlannedScenario& planned) {
  double before_ms = thread_cpu_ms();
  TaskProblem problem = task_problem_of(scenario);
  if (const auto what = problem_of(problem)) throw ConfigError(*what);
  planned.prepare_ms = thread_cpu_ms() - before_ms;
  const Budget budget{request, go_on};
  TaskPlanner planner{std::move(problem), Rng{request.seed}};
  planned.first_plan_ms = budget.spent_ms();
  const auto most = request.rollouts.value_or(std::numeric_limits<std::int64_t>::max());
  planner.run(most, [&] { return budget.is_over(planner.rollouts()); });
  auto plan = planner.best();
  if (!plan) throw ConfigError("no plan was found");
  planned.compute_ms = budget.spent_ms();
  planned.rollouts = planner.rollouts();
  planned.result = std::move(*plan);
}

}  // namespace

PlannedScenario plan_scenario(const PlanningScenario& scenario, const PlanRequest& request,
                              const std::function<bool(double)>& go_on) {
  PlannedScenario planned;
  planned.role = role_in(scenario);
  if (scenario.search) {
    plan_search(scenario, request, go_on, planned);
  } else {
    plan_team_task(scenario, request, go_on, planned);
  }
  return planned;
}

}  // namespace tandem::cli
