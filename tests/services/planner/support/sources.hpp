#pragma once

#include <string>

#include "services/planner/core/srs/reward_account.hpp"

namespace tandem {

/// A source without a limit, `rate_per_s` within `radius_m`.
inline RewardSource disc_source(const std::string& id, const Eigen::Vector2d& centre, double radius_m,
                                double rate_per_s) {
  RewardSource source;
  source.id = id;
  source.boundary = Disc{centre, radius_m};
  source.rate_per_s = rate_per_s;
  return source;
}

inline AgentMove move(const std::string& agent, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return {agent, from, to};
}

}  // namespace tandem
