#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "tests/services/planner/support/search_case.hpp"

namespace tandem {

/// A corridor of 12 m x 1 m from (0.5, 0.5) on, searched from (4.75, 1) by agents who walk 1 m/s and find what comes
/// within 0.6 m at first sight.
inline SearchCase corridor(std::size_t agents) {
  Searcher agent = test_person();
  agent.speed_mps = 1.0;
  agent.view_max_m = 0.6;
  agent.detection_rate_per_s = std::numeric_limits<double>::infinity();
  return {empty_room(12, 1), {4.75, 1.0}, std::vector<Searcher>(agents, agent), 0.6};
}

/// All of the mass at two places in the middle of the corridor.
inline void place_mass(SearchCase& search, double x_a, double mass_a, double x_b, double mass_b) {
  auto& mass = search.problem.masses.front();
  std::fill(mass.begin(), mass.end(), 0.0);
  mass[static_cast<std::size_t>(*search.world().area().cell_at(Eigen::Vector2d{x_a, 1.0}))] = mass_a;
  mass[static_cast<std::size_t>(*search.world().area().cell_at(Eigen::Vector2d{x_b, 1.0}))] = mass_b;
}

}  // namespace tandem
