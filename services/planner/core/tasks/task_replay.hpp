#pragma once

#include "services/planner/core/tasks/task_model.hpp"
#include "services/planner/core/tasks/task_plan.hpp"

namespace tandem {

/// The plan that a complete chain of decisions is: who is where when, what is drained when. Its bound and rollouts are
/// left to the caller.
[[nodiscard]] TaskPlan replayed(TaskModel& model, const std::vector<TaskAction>& decisions);

/// Whether each agent walks as in the rejected plan: nearer than `near_m` on average over the first `window_s`
/// (digest A6).
[[nodiscard]] bool walks_like(const std::vector<TimedPath>& paths, const std::vector<TimedPath>& rejected,
                              double window_s = 30.0, double near_m = 2.0);

/// How many visits the decisions begin with just as `sequences` has them, over all agents.
[[nodiscard]] std::size_t visits_in_common(const RewardWorld& world, const std::vector<TaskAction>& decisions,
                                           const std::vector<std::vector<std::string>>& sequences);

}  // namespace tandem
