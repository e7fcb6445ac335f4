#pragma once

#include "services/planner/core/scenario/planning_scenario.hpp"
#include "services/planner/core/tasks/task_problem.hpp"

namespace tandem {

/// The task of a planning scenario: its team, world, layers and horizon. Throws MapError.
[[nodiscard]] TaskProblem task_problem_of(const PlanningScenario& scenario);

}  // namespace tandem
