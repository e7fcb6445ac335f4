#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/planning/loop/closed_loop.hpp"

namespace tandem::bench {

/// How a planner's first plan of an instance gets better with time, and what is known of the best there is.
struct FirstPlanRecord {
  struct Key {
    std::string family;
    std::uint64_t seed = 0;
    std::string planner;
    std::uint64_t planner_seed = 1;

    friend auto operator<=>(const Key&, const Key&) = default;
  };
  Key key;
  double prepare_ms = 0.0;     ///< processor time for the map, once
  double first_plan_ms = 0.0;  ///< until the first plan
  double first_value_s = 0.0;
  std::vector<double> budgets_ms;
  std::vector<double> values_s;  ///< E[T] of the best plan after each budget
  std::vector<double> bounds_s;  ///< its certified lower bound, 0: none
  std::vector<int> rollouts;
  double sweep_bound_s = 0.0;  ///< the independent lower bound
  double exact_s = 0.0;        ///< the optimum over the lookouts, 0: not computed
  bool exact_proven = false;

  template <typename Self, typename Visitor>
  static void visit_fields(Self& record, Visitor&& field) {
    field("family", record.key.family);
    field("seed", record.key.seed);
    field("planner", record.key.planner);
    field("planner_seed", record.key.planner_seed);
    field("prepare_ms", record.prepare_ms);
    field("first_plan_ms", record.first_plan_ms);
    field("first_value_s", record.first_value_s);
    field("budgets_ms", record.budgets_ms);
    field("values_s", record.values_s);
    field("bounds_s", record.bounds_s);
    field("rollouts", record.rollouts);
    field("sweep_bound_s", record.sweep_bound_s);
    field("exact_s", record.exact_s);
    field("exact_proven", record.exact_proven);
  }
};

struct FirstPlanRequest {
  FirstPlanRecord::Key key;
  std::vector<double> budgets_ms;  ///< ascending
  bool exact = false;              ///< Compute the optimum too: only for small worlds.
};

[[nodiscard]] FirstPlanRecord made_first_plan(const FirstPlanRequest& request);

/// The problem of an instance at its beginning, on `world` with the prior `mass`: plans are compared over the time of
/// 2.5 sweeps of the area.
[[nodiscard]] SearchProblem problem_at_start(const PlanningInstance& instance, SearchWorld& world,
                                             const std::vector<double>& mass);

}  // namespace tandem::bench
