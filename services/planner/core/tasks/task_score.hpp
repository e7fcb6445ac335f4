#pragma once

#include "services/planner/core/tasks/task_model.hpp"

namespace tandem {

/// How promising a decision looks at once, > 0: the reward it leads to, and part of what it opens for others, against
/// the time it takes to the power of `impatience`. A guess that orders the search; values come from the model.
class TaskScore {
 public:
  /// `model` must outlive it.
  explicit TaskScore(TaskModel& model);
  [[nodiscard]] double operator()(const TaskState& state, const TaskAction& action, double impatience);

 private:
  [[nodiscard]] double worth_of(const TaskState& state, std::size_t source, std::size_t agent) const;

  TaskModel& model_;
  double unit_ = 1.0;  ///< the largest reward of any source: scores do not change when all rewards are scaled
  std::vector<std::vector<std::size_t>> opens_;     ///< by source: sources that wait for it
  std::vector<std::vector<std::size_t>> silences_;  ///< by source: sources that pay only before it is consumed
};

}  // namespace tandem
