#pragma once

#include <array>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "services/common/random.hpp"
#include "services/planner/core/paper/action_tree.hpp"

namespace tandem {

inline constexpr std::size_t kMostAgents = 8;

/// A state of the joint plan (paper 4.4.1): what each agent is doing, and for how long it still will.
///
/// A state ends when any action does. Only agents whose action has ended choose the next one; one without a next action
/// waits, which never ends (digest F5-F9). Times are whole milliseconds.
struct JointState {
  static constexpr std::int64_t kForEver = std::numeric_limits<std::int64_t>::max();

  std::int64_t time_ms = 0;                         ///< t_s: when the state is reached
  std::array<int, kMostAgents> ongoing{};           ///< x_s: of each agent the action under way, in its action set
  std::array<std::int64_t, kMostAgents> left_ms{};  ///< rt_s: how long each of them still takes; kForEver: it waits
};

/// Agents as the joint states see them: their action sets, each pointer outlives its use.
using ActionTrees = std::span<ActionTree* const>;

/// The state before the first choice: every agent in the virtual action at its root, which for those under way already
/// lasts as long as `ready_ms` says (digest F8).
[[nodiscard]] JointState root_state(std::span<const std::int64_t> ready_ms);

/// How many states can follow (13): the product over all agents whose action has ended, those without a next action
/// counting 1.
[[nodiscard]] std::size_t branching(const JointState& state, ActionTrees trees);

/// The state that follows when each agent whose action has ended goes on as `choose(agent, action)` says, an index into
/// the eligible children of the ended action, and time runs until the next end of an action. Waits are left out.
[[nodiscard]] JointState next_state(const JointState& state, ActionTrees trees,
                                    const std::function<std::size_t(std::size_t agent, int action)>& choose);

/// Whether nothing is to follow: all wait, or the horizon is reached.
[[nodiscard]] bool is_final(const JointState& state, ActionTrees trees, std::int64_t horizon_ms);

/// Algorithm 2: from `state` on, each choice drawn from q, until a final state, which is returned. In trees the last
/// actions say what was done before, so that the final state is the whole chain.
[[nodiscard]] JointState rollout(JointState state, ActionTrees trees, std::int64_t horizon_ms, Rng& rng);

}  // namespace tandem
