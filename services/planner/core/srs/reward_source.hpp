#pragma once

#include <limits>
#include <string>
#include <vector>

#include "services/planner/core/srs/boundary.hpp"

namespace tandem {

/// What a reward comes from: the environment, the agent's own action, the task, other agents (paper 3.1.3-3.1.6).
enum class SourceKind { Environment, Action, Task, Interaction };

/// How a source pays for a second inside its boundary.
enum class Flow {
  Steady,        ///< `rate_per_s`, until the pool is empty
  Proportional,  ///< `rate_per_s` times what is left: the chance of detection in a search cell (digest G2)
};

/// A social reward source: pays for each second spent inside its boundary, until its pool is empty.
///
/// A cell worth searching, the place a person asked us to go to, a wall that costs. See docs/srs_model.md, (1)-(6).
struct RewardSource {
  std::string id;
  SourceKind kind = SourceKind::Task;
  std::string meaning;  ///< for people
  Boundary boundary;
  Flow flow = Flow::Steady;
  double rate_per_s = 0.0;  ///< Reward for a second inside [1/s]; negative repels.
  /// Outside, at distance d [m]: outer_rate_per_s * exp(-d / outer_reach_m). Only for sources without a limit.
  double outer_rate_per_s = 0.0;
  double outer_reach_m = 1.0;
  /// All it can ever pay, of this sign; reward of the other sign is without limit (digest B3).
  double pool = std::numeric_limits<double>::infinity();
  std::vector<std::string> targets;  ///< agents that may consume it; empty: all
};

/// The reward of a second at `point_in_map` with a full pool [1/s], equation (1).
[[nodiscard]] double rate_at(const RewardSource& source, const Eigen::Vector2d& point_in_map);

/// Whether `agent` may consume the source, equation (10).
[[nodiscard]] bool is_target(const RewardSource& source, const std::string& agent);

}  // namespace tandem
