#include "bench/planning/records/run_record.hpp"

#include <numeric>

#include "bench/planning/statistics/statistics.hpp"
#include "services/common/format.hpp"

namespace tandem::bench {
std::string budget_label(const PlanningBudget& budget) {
  return budget.rollouts ? formatted("%drollouts", *budget.rollouts) : formatted("%gms", budget.cpu_ms);
}

RunRecord record_of(const RunKey& key, const PlanningInstance& instance, const LoopResult& result) {
  RunRecord record;
  record.key = key;
  record.finished = result.finished;
  record.expected_time_s = result.score.expected_time_s;
  record.probability_left = result.score.probability_left;
  record.duration_s = result.duration_s;
  record.found_by_60_s = result.score.found_by_60_s;
  record.found_by_120_s = result.score.found_by_120_s;
  record.found_by_300_s = result.score.found_by_300_s;
  record.found_by_600_s = result.score.found_by_600_s;
  record.half_found_s = result.score.half_found_s;
  record.found95_s = result.score.found95_s;
  record.all_found_s = result.score.all_found_s;
  record.overlap = result.score.overlap;
  record.distance_m = result.score.distance_m;
  const double all_m = std::accumulate(record.distance_m.begin(), record.distance_m.end(), 0.0);
  for (std::size_t m = 0; m < record.distance_m.size(); ++m) {
    if (all_m > 0.0 && instance.searchers[m].id.starts_with("person"))
      record.human_share += record.distance_m[m] / all_m;
  }
  record.prepare_ms = result.prepare_ms;
  record.first_plan_ms = result.first_plan_ms;
  if (!result.replan_ms.empty()) {
    record.replan_p50_ms = quantile(result.replan_ms, 0.5);
    record.replan_p95_ms = quantile(result.replan_ms, 0.95);
    record.replan_p99_ms = quantile(result.replan_ms, 0.99);
  }
  record.first_value_s = result.first_value_s;
  record.first_bound_s = result.first_bound_s;
  record.sweep_bound_s = result.sweep_bound_s;
  record.replans = static_cast<int>(result.replan_ms.size());
  record.rollouts = result.rollouts;
  record.fallbacks = result.fallbacks;
  record.repeated = result.repeated;
  record.plan_change_m = result.plan_change_m;
  return record;
}

}  // namespace tandem::bench
