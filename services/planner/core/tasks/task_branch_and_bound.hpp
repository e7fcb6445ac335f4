#pragma once

#include <cstdint>
#include <vector>

#include "services/planner/core/tasks/task_bound.hpp"
#include "services/planner/core/tasks/task_incumbent.hpp"

namespace tandem {

/// Looks at all plans that the bound does not rule out, depth first, the most hopeful decision first. In small worlds
/// it comes to an end: then no plan is worth more than the incumbent.
class TaskBranchAndBound {
 public:
  /// `model` and `incumbent` must outlive it.
  TaskBranchAndBound(TaskModel& model, TaskIncumbent& incumbent);

  /// Looks at so many more decisions; one state's are looked at together, and made up for by the next calls.
  void go_on(std::int64_t decisions);
  /// Everything was looked at or ruled out.
  [[nodiscard]] bool is_finished() const { return levels_.empty(); }
  /// No plan that was neither looked at nor ruled out is worth more; never rises.
  [[nodiscard]] double bound() const;

 private:
  /// A decision that may be taken next.
  struct Branch {
    TaskAction action;
    TaskState state;  ///< after it
    double bound = 0.0;
  };
  struct Level {
    std::vector<Branch> branches;  ///< the most hopeful first
    std::size_t next = 0;
  };

  void branch(const TaskState& state, double bound);

  TaskModel& model_;
  TaskIncumbent& incumbent_;
  TaskBound bound_of_;
  std::vector<Level> levels_;
  std::vector<TaskAction> decisions_;  ///< that led to the last level
  std::vector<TaskAction> actions_;
  std::int64_t credit_ = 0;  ///< decisions to be looked at
};

}  // namespace tandem
