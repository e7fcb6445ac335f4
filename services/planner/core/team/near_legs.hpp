#pragma once

#include <vector>

#include "services/planner/core/team/prepared_problem.hpp"

namespace tandem {

/// The legs of which all walks of the members of one capability consist: between near places.
struct NearLegs {
  struct Entry {
    int from = -1;
    int to = -1;
    const Leg* leg = nullptr;
  };
  ActionSet* actions = nullptr;
  int searcher = 0;  ///< of the world, one of that capability
  std::vector<std::size_t> members;
  std::vector<Entry> legs;         ///< only from places that somebody reaches within the horizon
  std::vector<double> earliest_s;  ///< per place, when somebody can be there
  /// Whether a walk over these legs leads from each place reached to all places that any way leads to.
  bool complete = true;
};

/// Per capability of the members that move.
[[nodiscard]] std::vector<NearLegs> near_legs(const PreparedProblem& problem);

}  // namespace tandem
