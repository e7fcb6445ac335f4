#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "services/cli/plan/plan_picture.hpp"
#include "services/planner/core/roles/role.hpp"
#include "services/planner/core/team/search_problem.hpp"

namespace tandem::cli {

/// How a scenario is to be planned.
struct PlanRequest {
  std::string planner = "tandem";        ///< As named_planner() takes it.
  double budget_ms = 200.0;              ///< Processor time of the plan, preparation apart.
  std::optional<std::int64_t> rollouts;  ///< Instead of the budget.
  std::uint64_t seed = 1;
};

/// A plan of a search.
struct PlannedSearch {
  JointPlan plan;              ///< The paths end at fixed goals and the horizon.
  double lower_bound_s = 0.0;  ///< No plan has a smaller expected time; 0: not known.
  std::vector<double> found;   ///< probability that all is found by 0, kFoundStep_s, ..., to the horizon
  PicturedBelief belief;       ///< before the search, over all objects
};

inline constexpr double kFoundStep_s = 0.5;

/// A scenario's plan, and what it took.
struct PlannedScenario {
  std::variant<PlannedSearch, TaskPlan> result;
  Role role = Role::LeaderFollower;
  std::int64_t rollouts = 0;
  double prepare_ms = 0.0;     ///< Once for a map [ms of processor time].
  double first_plan_ms = 0.0;  ///< Until there was a plan, preparation apart.
  double compute_ms = 0.0;     ///< All of the planning, preparation apart.
};

/// Plans a scenario: a search with any planner of named_planner(), a task without search with "tandem", which is then
/// the planner of tasks. The planner must exist.
///
/// `go_on` hears the share of the work that is done, and ends it by saying no; the best plan so far is given. Throws
/// ConfigError on a scenario that cannot be planned (it says what key is why, not in which file), MapError, and
/// RemotePlannerError.
[[nodiscard]] PlannedScenario plan_scenario(const PlanningScenario& scenario, const PlanRequest& request,
                                            const std::function<bool(double share)>& go_on);

}  // namespace tandem::cli
