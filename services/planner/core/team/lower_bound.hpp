#pragma once

#include "services/planner/core/team/prepared_problem.hpp"

namespace tandem {

/// An expected time to find all objects that no plan of the problem beats [s]; 0 if none is known.
///
/// Plans are walks of each member over legs between near places: from a place to the lookouts nearest to it, and to its
/// goal from the lookouts nearest to that, all else being chains of such legs. Looks of CellPrices cost time, so by t
/// the team has found no more than the cells with most mass per price that the time until then pays for and that can be
/// in view by then, and what is looked at anyway. E[T] is at least the integral of what is left; of several objects, of
/// the probability that one of them is.
///
/// With people who may not follow the plan it is the mean over what they may do. Unknown where lookouts exist that no
/// chain of near legs leads to.
[[nodiscard]] double lower_bound_s(const PreparedProblem& problem);

}  // namespace tandem
