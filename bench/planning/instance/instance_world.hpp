#pragma once

#include <memory>
#include <vector>

#include "bench/planning/instance/families.hpp"
#include "services/planner/core/team/search_world.hpp"

namespace tandem::bench {

/// The world of an instance, with nothing prepared but what its construction needs.
[[nodiscard]] std::unique_ptr<SearchWorld> world_of(const PlanningInstance& instance);

/// Which search cells somebody of the team sees from somewhere it can get to.
[[nodiscard]] std::vector<bool> visible_cells(SearchWorld& world, const PlanningInstance& instance);

/// The prior of an instance on its cells, in all 1, all of it where somebody can see it.
[[nodiscard]] std::vector<double> prior_mass(SearchWorld& world, const PlanningInstance& instance);

}  // namespace tandem::bench
