#pragma once

#include <cstdint>
#include <vector>

#include "services/planner/core/tasks/task_state.hpp"

namespace tandem {

/// A complete joint plan as its decisions.
struct TaskCandidate {
  std::vector<TaskAction> decisions;
  double value = 0.0;
  std::int64_t makespan_ms = 0;
};

/// Keeps the best complete plan found, and says what is worth a closer look.
class TaskIncumbent {
 public:
  virtual ~TaskIncumbent() = default;
  /// A complete plan was found; `final_state` is its end.
  virtual void offer(const std::vector<TaskAction>& decisions, const TaskState& final_state) = 0;
  /// Whether a plan of at most this value that ends no sooner than this could take the place of the best.
  [[nodiscard]] virtual bool can_be_beaten_by(double bound, std::int64_t least_makespan_ms) const = 0;
  [[nodiscard]] virtual double value() const = 0;
  /// The decisions of the best plan.
  [[nodiscard]] virtual const std::vector<TaskAction>& decisions() const = 0;
};

}  // namespace tandem
