#pragma once

#include <vector>

#include "bench/planning/instance/families.hpp"
#include "services/planner/core/search/search_area.hpp"

namespace tandem::bench {

/// Takes up a hint: cells near it become so many times likelier, the sum of `mass` stays.
void take_hint(std::vector<double>& mass, const SearchArea& area, const WorldEvent& hint);

}  // namespace tandem::bench
