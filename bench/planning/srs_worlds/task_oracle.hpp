#pragma once

#include <cstdint>
#include <limits>

#include "services/planner/core/tasks/task_planner.hpp"

namespace tandem::bench {

/// Which plans need not be looked at.
enum class OraclePruning {
  None,   ///< every order of every action of everybody
  Bound,  ///< not where TaskBound says that nothing better can come
};

/// What an exhaustive search found.
struct OracleResult {
  double value = -std::numeric_limits<double>::infinity();  ///< g of the best plan
  std::int64_t decisions = 0;                               ///< looked at
  bool is_complete = false;                                 ///< nothing was left out for lack of time
};

/// The best value of all joint plans of the action model, by depth-first branch and bound: every order, who does what,
/// and every end of a stay. Plans worth no more than `floor` are not looked for.
[[nodiscard]] OracleResult best_task_value(const TaskProblem& problem, OraclePruning pruning,
                                           std::int64_t most_decisions,
                                           double floor = -std::numeric_limits<double>::infinity());

}  // namespace tandem::bench
