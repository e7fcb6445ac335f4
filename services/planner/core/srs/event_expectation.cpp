#include "services/planner/core/srs/event_expectation.hpp"

#include <algorithm>
#include <cmath>

#include "services/planner/core/srs/quadrature.hpp"

namespace tandem {

bool EventExpectation::concerns(const DrawList::Draw& draw) const {
  return std::ranges::any_of(world_.sources()[draw.source].expected_by, [&](std::size_t gate) {
    return (world_.gates()[gate].agents & mask_of(draw.agent)) != 0;
  });
}

double EventExpectation::expected_amount(const DrawList::Draw& draw, const JointMove& joint, double length_s) const {
  const auto expected_per_s = [&](double later_s) {
    double not_yet = 1.0;
    for (const std::size_t gate : world_.sources()[draw.source].expected_by) {
      if ((world_.gates()[gate].agents & mask_of(draw.agent)) == 0) continue;
      not_yet *= 1.0 - probability(world_.gates()[gate].pool, later_s);
    }
    return not_yet * draws_.per_s_at(draw, world_, joint, now_s_ + later_s);
  };
  return integral(expected_per_s, 0.0, length_s, 1e-12 * std::abs(draw.per_s) * length_s);
}

double EventExpectation::probability(std::size_t event, double later_s) const {
  double sum = state_.drawn[event];
  for (const std::size_t pool : draws_.pools()) {
    if (std::ranges::count(world_.pools()[pool].feeds, event) == 0) continue;
    sum -= state_.left[pool] * std::expm1(-draws_.outflow_per_s(pool) * later_s);
  }
  return std::min(sum, 1.0);
}

}  // namespace tandem
