#pragma once

#include <vector>

#include "bench/paths/path_case.hpp"

namespace tandem::bench {

/// How well our own ways do: with the clearance that robots prefer, and with none but their body's; straight over the
/// motion map, as to a fixed goal, and over lookouts, as between far lookouts of a plan. These lead from the lookout
/// nearest to the start to that nearest to the goal.
[[nodiscard]] std::vector<PathRecord> own_ways(const PathCase& one);

}  // namespace tandem::bench
