#pragma once

#include <cstdint>

#include "bench/planning/srs_worlds/srs_world.hpp"

namespace tandem::bench {

/// How good the task planner is on a random world of reward sources (S7).
struct TaskRecord {
  struct Key {
    std::uint64_t seed = 0;
    int most_sources = 8;
    double budget_ms = 200.0;

    friend auto operator<=>(const Key&, const Key&) = default;
  };
  Key key;
  int sources = 0;
  int agents = 0;
  double first_plan_ms = 0.0;
  double first_value = 0.0;
  double value = 0.0;        ///< g of the plan after the budget
  double upper_bound = 0.0;  ///< certified
  double best_known = 0.0;   ///< the optimum if it is proven
  bool optimum_proven = false;
  double optimum_gap = 0.0;  ///< how much of the best known value the plan lacks, as a part of it

  template <typename Self, typename Visitor>
  static void visit_fields(Self& record, Visitor&& field) {
    field("seed", record.key.seed);
    field("most_sources", record.key.most_sources);
    field("budget_ms", record.key.budget_ms);
    field("sources", record.sources);
    field("agents", record.agents);
    field("first_plan_ms", record.first_plan_ms);
    field("first_value", record.first_value);
    field("value", record.value);
    field("upper_bound", record.upper_bound);
    field("best_known", record.best_known);
    field("optimum_proven", record.optimum_proven);
    field("optimum_gap", record.optimum_gap);
  }
};

struct TaskRequest {
  TaskRecord::Key key;
};

/// Plans the task, and looks for its optimum by branch and bound with a limit of decisions.
[[nodiscard]] TaskRecord made_task_run(const TaskRequest& request);

}  // namespace tandem::bench
