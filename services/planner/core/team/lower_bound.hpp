#pragma once

#include "services/planner/core/team/prepared_problem.hpp"

namespace tandem {

/// An expected time that no plan of the problem can beat, however its members move [s]; with several objects, that of
/// the one that takes longest. 0 where a person may not follow the plan or there is nothing to be found.
///
/// What is seen by time t lies within view of where somebody can be by then, and within the strip that the team can
/// have swept: the view around each start and, for each metre walked, as wide as the view. So by t no more is found
/// than the densest cells in reach, up to the area swept, and what is looked at anyway; to see is taken as to find.
/// E[T] is at least the integral of what is left then (digest 4, bounds). A member looks from the point of its search
/// cell, and an object may lie anywhere in its own, so views count as longer by a cell's diagonal. Time: 200 passes
/// over the cells.
[[nodiscard]] double lower_bound_s(const PreparedProblem& problem);

}  // namespace tandem
