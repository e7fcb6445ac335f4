#include "services/planner/core/srs/reward_source.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {

double rate_at(const RewardSource& source, const Eigen::Vector2d& point_in_map) {
  if (contains(source.boundary, point_in_map)) {
    return source.flow == Flow::Proportional ? source.rate_per_s * source.pool : source.rate_per_s;
  }
  if (source.outer_rate_per_s == 0.0) return 0.0;
  return source.outer_rate_per_s * std::exp(-signed_distance(source.boundary, point_in_map) / source.outer_reach_m);
}

bool is_target(const RewardSource& source, const std::string& agent) {
  return source.targets.empty() || std::ranges::find(source.targets, agent) != source.targets.end();
}

}  // namespace tandem
