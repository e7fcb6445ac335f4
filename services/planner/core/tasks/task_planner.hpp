#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "services/common/random.hpp"
#include "services/planner/core/tasks/task_plan.hpp"
#include "services/planner/core/tasks/task_problem.hpp"

namespace tandem {

/// Plans a task of reward sources for a team, anytime: more rollouts never make the plan worse.
///
/// Equal problem, seed and number of rollouts give the same plan, bit for bit.
class TaskPlanner {
 public:
  /// Finds a first plan at once. `problem` must have no problem_of().
  TaskPlanner(TaskProblem problem, Rng rng);
  ~TaskPlanner();
  TaskPlanner(TaskPlanner&&) noexcept;
  TaskPlanner& operator=(TaskPlanner&&) noexcept;

  /// Goes on until so many more rollouts are done, `stop` says so (asked after each), or nothing better can exist.
  void run(std::int64_t rollouts, const std::function<bool()>& stop = {});
  /// Nothing better can exist.
  [[nodiscard]] bool is_finished() const;
  [[nodiscard]] std::int64_t rollouts() const;
  /// The value of the best plan so far, and what no plan exceeds.
  [[nodiscard]] double value() const;
  [[nodiscard]] double upper_bound() const;
  /// The best plan so far, with all that a picture of it needs; none if every plan is like a rejected one.
  ///
  /// Of plans of equal value, the one that ends first; then the one most like the plan in execution; then the first in
  /// the order of decisions (digest A3).
  [[nodiscard]] std::optional<TaskPlan> best();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// The plan after so many rollouts.
[[nodiscard]] std::optional<TaskPlan> plan_task(const TaskProblem& problem, std::int64_t rollouts, Rng rng);

}  // namespace tandem
