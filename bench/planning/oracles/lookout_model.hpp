#pragma once

#include "bench/planning/oracles/exact_search.hpp"
#include "services/planner/core/team/search_problem.hpp"

namespace tandem::bench {

/// A problem as the actions that planners choose from: going from lookout to lookout on the legs of the action sets,
/// and what is seen on them. First sight only, at most 64 search cells, nobody with a committed path or a goal.
[[nodiscard]] ExactModel lookout_model(const SearchProblem& problem);

}  // namespace tandem::bench
