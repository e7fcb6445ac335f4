#include "services/planner/core/srs/reward_source.hpp"

#include <algorithm>
#include <cassert>

namespace tandem {

double pool_of_consumption(const RewardRatio& inside, double consumption_s) {
  return peak_of(inside) * consumption_s;
}

double rate_at(const RewardSource& source, const Eigen::Vector2d& point_in_map) {
  const auto shape = shape_in_map(source.boundary);
  assert(shape);
  const BoundaryVector vector = vector_to(*shape, point_in_map);
  if (vector.distance > kOnBoundary_m) return ratio_at(source.outside, vector);
  return ratio_at(source.inside, vector) * (source.flow == Flow::Proportional ? source.pool : 1.0);
}

bool is_target(const RewardSource& source, const std::string& agent) {
  if (source.targets.empty()) return std::ranges::count(owners_of(source.boundary), agent) == 0;
  return std::ranges::count(source.targets, agent) > 0;
}

std::vector<std::string> owners_of(const Boundary& boundary) {
  std::vector<std::string> owners;
  if (const auto* attached = std::get_if<Attached>(&boundary)) owners.push_back(attached->agent);
  if (const auto* between = std::get_if<Between>(&boundary)) {
    for (const Anchor* anchor : {&between->from, &between->to}) {
      if (!anchor->agent.empty()) owners.push_back(anchor->agent);
    }
  }
  return owners;
}

}  // namespace tandem
