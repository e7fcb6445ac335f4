#pragma once

#include <vector>

#include "bench/planning/instance/families.hpp"
#include "services/planner/core/search/search_area.hpp"

namespace tandem::bench {

/// A bound that no search of `instance` can beat, whoever plans it: the expected time to find [s].
///
/// Whatever was seen by t lies within the view of the way walked so far, so it covers at most
/// sum of (pi r^2 + 2 r v t), and at best the floor where the object is likeliest; and a cell is not seen before
/// somebody can be within view of it. E[T] >= integral of 1 - min of both. `prior` adds up to 1.
///
/// r is the view's range and a little more, as a searcher in plans looks from the middle of its search cell.
[[nodiscard]] double sweep_lower_bound_s(const PlanningInstance& instance, const SearchArea& area,
                                         const std::vector<OccupancyGrid>& layers, const std::vector<double>& prior);

/// The length of the shortest way from `from_in_map` to each cell of `map` over free cells, never more than that: a way
/// on eight neighbours is at most 8.24 % longer than the straight one. Infinite where none leads.
[[nodiscard]] std::vector<float> least_distances_m(const OccupancyGrid& map, const Eigen::Vector2d& from_in_map);

}  // namespace tandem::bench
