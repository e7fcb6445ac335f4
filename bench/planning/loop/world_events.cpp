#include "bench/planning/loop/world_events.hpp"

#include <numeric>

namespace tandem::bench {

void take_hint(std::vector<double>& mass, const SearchArea& area, const WorldEvent& hint) {
  const double before = std::accumulate(mass.begin(), mass.end(), 0.0);
  for (int cell = 0; cell < area.size(); ++cell) {
    if ((area.point(cell) - hint.centre_in_map).norm() <= hint.radius_m) {
      mass[static_cast<std::size_t>(cell)] *= hint.factor;
    }
  }
  const double after = std::accumulate(mass.begin(), mass.end(), 0.0);
  for (double& here : mass) here *= after > 0.0 ? before / after : 1.0;
}

}  // namespace tandem::bench
