#include "services/planner/core/team/team_ground.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace tandem {

TeamGround team_ground(const PreparedProblem& problem) {
  TeamGround ground;
  ground.problem = &problem;
  const SearchProblem& search = problem.problem();
  std::vector<double> mass(search.masses.front().size(), 0.0);
  for (const auto& object : search.masses) std::ranges::transform(mass, object, mass.begin(), std::plus{});
  ground.mass.assign(mass.begin(), mass.end());
  ground.first_sight = true;
  for (const Look& look : problem.fixed_looks()) {
    const bool found = std::isinf(look.rate_per_s);
    ground.first_sight = ground.first_sight && found;
    for (std::size_t i = 0; i < look.seen->size(); ++i) {
      const double stay_s = look.seen->leave_s[i] - look.seen->enter_s[i];
      mass[static_cast<std::size_t>(look.seen->cells[i])] *= found ? 0.0 : std::exp(-look.rate_per_s * stay_s);
    }
  }
  for (std::size_t m = 0; m < problem.members().size(); ++m) {
    LegBook* book = &search.world->book(search.members[m].searcher);
    ground.books.push_back(book);
    ground.start_views.push_back(problem.members()[m].stay->cells);
    ground.first_sight = ground.first_sight && book->first_sight();
  }
  ground.unpromised.assign(mass.begin(), mass.end());
  return ground;
}

std::size_t cells_until(const CompactLeg& leg, double end_s) {
  if (leg.duration_s <= end_s) return leg.cells.size();
  return static_cast<std::size_t>(std::ranges::lower_bound(leg.enter_s, end_s) - leg.enter_s.begin());
}

float take_detected(const CompactLeg& leg, std::size_t cells, bool first_sight, std::vector<float>& mass) {
  float taken = 0.0F;
  for (std::size_t i = 0; i < cells; ++i) {
    float& here = mass[static_cast<std::size_t>(leg.cells[i])];
    const float left = first_sight ? 0.0F : here * leg.kept[i];
    taken += here - left;
    here = left;
  }
  return taken;
}

}  // namespace tandem
