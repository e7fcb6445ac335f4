#include "bench/planning/srs_worlds/task_oracle.hpp"

#include <algorithm>

#include "services/planner/core/tasks/task_bound.hpp"

namespace tandem::bench {
namespace {

class Search {
 public:
  Search(const TaskProblem& problem, OraclePruning pruning, std::int64_t most_decisions, double floor)
      : model_(problem), bound_(model_), pruning_(pruning), most_decisions_(most_decisions) {
    result_.value = floor;
  }

  OracleResult run() {
    result_.is_complete = true;
    explore(model_.start());
    return result_;
  }

 private:
  void explore(const TaskState& state) {
    if (model_.decider(state) == TaskModel::kNobody) {
      result_.value = std::max(result_.value, state.value);
      return;
    }
    std::vector<TaskAction> actions;
    model_.actions(state, actions);
    struct Next {
      TaskState state;
      double bound;
    };
    std::vector<Next> all;
    for (const TaskAction& action : actions) {
      if (result_.decisions >= most_decisions_) {
        result_.is_complete = false;
        return;
      }
      ++result_.decisions;
      TaskState next = model_.after(state, action);
      const double bound = pruning_ == OraclePruning::Bound ? bound_(next, result_.value) : 0.0;
      all.push_back({std::move(next), bound});
    }
    if (pruning_ == OraclePruning::Bound) {
      std::ranges::stable_sort(all, [](const Next& a, const Next& b) { return a.bound > b.bound; });
    }
    for (const Next& next : all) {
      if (pruning_ == OraclePruning::Bound && next.bound <= result_.value + 1e-7) continue;
      explore(next.state);
      if (!result_.is_complete) return;
    }
  }

  TaskModel model_;
  TaskBound bound_;
  OraclePruning pruning_;
  std::int64_t most_decisions_;
  OracleResult result_;
};

}  // namespace

OracleResult best_task_value(const TaskProblem& problem, OraclePruning pruning, std::int64_t most_decisions,
                             double floor) {
  return Search{problem, pruning, most_decisions, floor}.run();
}

}  // namespace tandem::bench
