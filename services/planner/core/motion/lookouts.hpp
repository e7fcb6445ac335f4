#pragma once

#include <vector>

#include "services/planner/core/motion/motion_map.hpp"
#include "services/planner/core/search/observability.hpp"

namespace tandem {

/// Standpoints from which together nearly all of the search area can be seen from within `range_m`: greedy set cover,
/// the best one first, until one more would show less than `least_gain_m2` of new floor (digest E2).
///
/// Only places that can be walked to from node `from` of `motion`; the result are nodes of `motion`.
[[nodiscard]] std::vector<int> covering_lookouts(Observability& observability, const MotionMap& motion, int from,
                                                 double range_m, double least_gain_m2);

}  // namespace tandem
