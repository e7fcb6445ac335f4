#pragma once

#include <limits>
#include <string>
#include <vector>

#include "services/planner/core/srs/boundary.hpp"
#include "services/planner/core/srs/reward_ratio.hpp"

namespace tandem {

/// What a reward comes from: the environment, the agent's own action, the task, other agents (7).
enum class SourceKind { Environment, Action, Task, Interaction };

/// How a source pays for a second at its ratio.
enum class Flow {
  Steady,        ///< the ratio, until the pool is empty
  Proportional,  ///< the ratio times what is left: the chance of detection in a search cell (digest G2)
};

/// How one agent differs from the others at a source.
struct AgentTemper {
  std::string agent;
  double pace = 1.0;   ///< It draws so many times the ratio, >= 0: how fast it works or detects.
  double worth = 1.0;  ///< What one unit drawn from the pool is worth to it (digest B7).
  bool operator==(const AgentTemper&) const = default;
};

/// A social reward source: pays for each second spent inside its boundary, until its pool is empty; outside it may
/// fade. See docs/srs_model.md, (1)-(6).
struct RewardSource {
  std::string id;
  SourceKind kind = SourceKind::Task;
  std::string meaning;  ///< for people
  Boundary boundary;
  RewardRatio inside;
  RewardRatio outside;  ///< zero: a source with a sharp edge
  Flow flow = Flow::Steady;
  /// All it can ever pay, of this sign, in its own units; reward of the other sign is without limit (digest B3).
  double pool = std::numeric_limits<double>::infinity();
  std::vector<std::string> targets;  ///< agents that may consume it (10); empty: all but the owner it is attached to
  std::vector<AgentTemper> tempers;  ///< agents that are not mentioned draw and value as the source says

  bool operator==(const RewardSource&) const = default;
};

/// The pool that lasts for `consumption_s` [s] where the ratio is largest (digest B6).
[[nodiscard]] double pool_of_consumption(const RewardRatio& inside, double consumption_s);

/// The reward of a second at a point with a full pool [1/s], equation (1). The boundary must be a fixed shape on the
/// map.
[[nodiscard]] double rate_at(const RewardSource& source, const Eigen::Vector2d& point_in_map);

/// Whether `agent` may consume the source (10). The owner of a moving boundary may only if it is listed (digest B8).
[[nodiscard]] bool is_target(const RewardSource& source, const std::string& agent);

/// The agents that the boundary moves with.
[[nodiscard]] std::vector<std::string> owners_of(const Boundary& boundary);

}  // namespace tandem
