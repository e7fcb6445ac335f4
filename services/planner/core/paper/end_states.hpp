#pragma once

#include <array>
#include <vector>

#include "services/planner/core/paper/joint_rollout.hpp"

namespace tandem {

/// The most rewarding ends of sequences of eligible actions, best first, at least `apart_m` from each other and at most
/// `count`; the root where nothing can be done.
[[nodiscard]] std::vector<int> rewarding_goals(const ActionTree& tree, std::size_t count, double apart_m);

/// Combinations of a goal of each agent, the best of all agents first, then those with ever later goals: at most
/// `count`. They are expanded before anything is drawn, so that there is a plan at once (paper 4.4.2).
[[nodiscard]] std::vector<std::array<int, kMostAgents>> end_state_candidates(
    const std::vector<std::vector<int>>& goals_of_agents, std::size_t count);

}  // namespace tandem
