#pragma once

#include <vector>

#include "bench/planning/loop/walked.hpp"
#include "services/planner/core/team/search_world.hpp"

namespace tandem::bench {

/// How good an executed search was: exact figures of the whole paths.
struct SearchScore {
  /// The integral of P(not found by t); what is left at the end counts as if found after the horizon and one more sweep
  /// of the area.
  double expected_time_s = 0.0;
  double probability_left = 0.0;
  double found_by_60_s = 0.0;  ///< P(found by then)
  double found_by_120_s = 0.0;
  double found_by_300_s = 0.0;
  double found_by_600_s = 0.0;
  double half_found_s = 0.0;  ///< until P(found) is 50 %; the horizon if never
  double found95_s = 0.0;
  double all_found_s = 0.0;  ///< until 99.9 %
  double overlap = 0.0;      ///< sum over searchers of the floor seen by each, over the floor seen by any, less 1
  std::vector<double> distance_m;
};

/// The figures of `walked`, a path for each searcher of the world, against the prior.
[[nodiscard]] SearchScore score_of(SearchWorld& world, const std::vector<double>& prior,
                                   const std::vector<Walked>& walked, double horizon_s);

}  // namespace tandem::bench
