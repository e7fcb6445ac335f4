#include "bench/planning/srs_worlds/task_run.hpp"

#include <algorithm>

#include "bench/planning/loop/cpu_clock.hpp"
#include "bench/planning/srs_worlds/task_oracle.hpp"

namespace tandem::bench {
namespace {

constexpr std::int64_t kMostDecisions = 3'000'000;
constexpr double kSame = 1e-6;

}  // namespace

TaskRecord made_task_run(const TaskRequest& request) {
  SrsWorldOptions options;
  options.most_sources = request.key.most_sources;
  if (options.most_sources > 8) options.least_sources = options.most_sources;
  const TaskProblem problem = random_srs_task(request.key.seed, options);
  TaskRecord record;
  record.key = request.key;
  record.sources = static_cast<int>(problem.world.sources.size());
  record.agents = static_cast<int>(problem.agents.size());
  const double begun_ms = thread_cpu_ms();
  TaskPlanner planner{problem, Rng{request.key.seed}};
  record.first_value = planner.value();
  record.first_plan_ms = thread_cpu_ms() - begun_ms;
  planner.run(1'000'000'000, [&] { return thread_cpu_ms() - begun_ms >= request.key.budget_ms; });
  record.value = planner.value();
  record.upper_bound = planner.upper_bound();
  record.best_known = record.value;
  record.optimum_proven = planner.is_finished();
  if (!record.optimum_proven) {
    const OracleResult oracle = best_task_value(problem, OraclePruning::Bound, kMostDecisions, record.value - kSame);
    record.best_known = std::max(record.value, oracle.value);
    record.optimum_proven = oracle.is_complete;
  }
  if (record.best_known > kSame) record.optimum_gap = (record.best_known - record.value) / record.best_known;
  return record;
}

}  // namespace tandem::bench
