#include "bench/planning/loop/first_plan.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "bench/planning/instance/instance_world.hpp"
#include "bench/planning/loop/cpu_clock.hpp"
#include "bench/planning/oracles/lookout_model.hpp"
#include "bench/planning/oracles/sweep_bound.hpp"
#include "services/planner/remote/named_planner.hpp"

namespace tandem::bench {
namespace {

constexpr std::uint64_t kExactNodes = 3'000'000;

}  // namespace

SearchProblem problem_at_start(const PlanningInstance& instance, SearchWorld& world, const std::vector<double>& mass) {
  SearchProblem problem;
  problem.world = &world;
  std::vector<int> all(instance.searchers.size());
  std::iota(all.begin(), all.end(), 0);
  for (const int m : all) {
    SearchMember member;
    member.searcher = m;
    member.pose = instance.starts[static_cast<std::size_t>(m)];
    member.battery_s = instance.searchers[static_cast<std::size_t>(m)].endurance_s;
    problem.members.push_back(member);
  }
  problem.masses = {mass};
  problem.tail_s = world.sweep_time_s(all);
  problem.horizon_s = std::max(1.0, std::min(kPlanHorizonSweeps * problem.tail_s, instance.horizon_s));
  return problem;
}

FirstPlanRecord made_first_plan(const FirstPlanRequest& request) {
  const PlanningInstance instance = instance_of(request.key.family, request.key.seed);
  FirstPlanRecord record;
  record.key = request.key;
  double before_ms = thread_cpu_ms();
  const auto world = world_of(instance);
  record.prepare_ms = thread_cpu_ms() - before_ms;
  const std::vector<double> prior = prior_mass(*world, instance);
  before_ms = thread_cpu_ms();
  while (world->prepare_next()) {
  }
  record.prepare_ms += thread_cpu_ms() - before_ms;
  const SearchProblem problem = problem_at_start(instance, *world, prior);
  const auto planner = named_planner(request.key.planner, 1e-3 * request.budgets_ms.back());
  before_ms = thread_cpu_ms();
  planner->begin(problem, Rng{request.key.planner_seed});
  record.first_plan_ms = thread_cpu_ms() - before_ms;
  // A budget is for planning; making a report of a plan takes time of its own.
  const auto best = [&] {
    const double asked_ms = thread_cpu_ms();
    JointPlan plan = planner->best();
    before_ms += thread_cpu_ms() - asked_ms;
    return plan;
  };
  record.first_value_s = best().forecast.expected_time_s;
  for (const double budget_ms : request.budgets_ms) {
    planner->run(std::numeric_limits<int>::max(), [&] { return thread_cpu_ms() - before_ms >= budget_ms; });
    const JointPlan plan = best();
    record.budgets_ms.push_back(budget_ms);
    record.values_s.push_back(plan.forecast.expected_time_s);
    record.rollouts.push_back(planner->rollouts());
  }
  record.bounds_s.assign(record.budgets_ms.size(), planner->lower_bound_s());
  record.sweep_bound_s = sweep_lower_bound_s(instance, world->area(), layers_of(instance), prior);
  if (request.exact) {
    const ExactPlan exact = exact_search(lookout_model(problem), record.values_s.back() + 1e-6, kExactNodes);
    record.exact_s = exact.expected_time_s;
    record.exact_proven = exact.proven;
  }
  return record;
}

}  // namespace tandem::bench
