#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/planning/loop/closed_loop.hpp"

namespace tandem::bench {

/// What was run: a line of a results file is known by it.
struct RunKey {
  std::string family;
  std::uint64_t seed = 0;  ///< of the instance
  std::string planner;     ///< NAME[:key=value,...]
  std::string budget;      ///< "200ms" or "500rollouts"
  std::uint64_t planner_seed = 1;

  friend auto operator<=>(const RunKey&, const RunKey&) = default;
};

[[nodiscard]] std::string budget_label(const PlanningBudget& budget);

/// One run in figures: what stands in a line of a results file.
struct RunRecord {
  RunKey key;
  bool finished = false;
  double expected_time_s = 0.0;
  double probability_left = 0.0;
  double duration_s = 0.0;
  double found_by_60_s = 0.0;
  double found_by_120_s = 0.0;
  double found_by_300_s = 0.0;
  double found_by_600_s = 0.0;
  double half_found_s = 0.0;
  double found95_s = 0.0;
  double all_found_s = 0.0;
  double overlap = 0.0;
  std::vector<double> distance_m;
  double human_share = 0.0;  ///< of the distance
  double prepare_ms = 0.0;
  double first_plan_ms = 0.0;
  double replan_p50_ms = 0.0;
  double replan_p95_ms = 0.0;
  double replan_p99_ms = 0.0;
  double first_value_s = 0.0;
  double first_bound_s = 0.0;
  double sweep_bound_s = 0.0;  ///< the independent lower bound of the instance
  int replans = 0;
  int rollouts = 0;
  int fallbacks = 0;
  int repeated = 0;  ///< plans like a rejected one
  double plan_change_m = 0.0;

  template <typename Self, typename Visitor>
  static void visit_fields(Self& record, Visitor&& field) {
    field("family", record.key.family);
    field("seed", record.key.seed);
    field("planner", record.key.planner);
    field("budget", record.key.budget);
    field("planner_seed", record.key.planner_seed);
    field("finished", record.finished);
    field("expected_time_s", record.expected_time_s);
    field("probability_left", record.probability_left);
    field("duration_s", record.duration_s);
    field("found_by_60_s", record.found_by_60_s);
    field("found_by_120_s", record.found_by_120_s);
    field("found_by_300_s", record.found_by_300_s);
    field("found_by_600_s", record.found_by_600_s);
    field("half_found_s", record.half_found_s);
    field("found95_s", record.found95_s);
    field("all_found_s", record.all_found_s);
    field("overlap", record.overlap);
    field("distance_m", record.distance_m);
    field("human_share", record.human_share);
    field("prepare_ms", record.prepare_ms);
    field("first_plan_ms", record.first_plan_ms);
    field("replan_p50_ms", record.replan_p50_ms);
    field("replan_p95_ms", record.replan_p95_ms);
    field("replan_p99_ms", record.replan_p99_ms);
    field("first_value_s", record.first_value_s);
    field("first_bound_s", record.first_bound_s);
    field("sweep_bound_s", record.sweep_bound_s);
    field("replans", record.replans);
    field("rollouts", record.rollouts);
    field("fallbacks", record.fallbacks);
    field("repeated", record.repeated);
    field("plan_change_m", record.plan_change_m);
  }
};

[[nodiscard]] RunRecord record_of(const RunKey& key, const PlanningInstance& instance, const LoopResult& result);

}  // namespace tandem::bench
