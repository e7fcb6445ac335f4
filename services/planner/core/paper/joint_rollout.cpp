#include "services/planner/core/paper/joint_rollout.hpp"

#include <algorithm>
#include <cassert>

namespace tandem {
namespace {

const Action& ongoing(const JointState& state, ActionTrees trees, std::size_t agent) {
  return (*trees[agent])[static_cast<std::size_t>(state.ongoing[agent])];
}

/// One of the probabilities, drawn.
std::size_t drawn(const std::vector<double>& probabilities, Rng& rng) {
  double left = rng.uniform();
  for (std::size_t i = 0; i + 1 < probabilities.size(); ++i) {
    left -= probabilities[i];
    if (left < 0.0) return i;
  }
  return probabilities.size() - 1;
}

template <typename Choose>
void advance(JointState& state, ActionTrees trees, const Choose& choose) {
  std::int64_t step_ms = JointState::kForEver;
  for (std::size_t agent = 0; agent < trees.size(); ++agent) {
    if (state.left_ms[agent] == 0) {
      const Action& ended = ongoing(state, trees, agent);
      if (ended.eligible.empty()) {
        state.left_ms[agent] = JointState::kForEver;
      } else {
        state.ongoing[agent] = ended.eligible[choose(agent, state.ongoing[agent])];
        state.left_ms[agent] = ongoing(state, trees, agent).duration_ms;
      }
    }
    step_ms = std::min(step_ms, state.left_ms[agent]);
  }
  if (step_ms == JointState::kForEver) return;
  state.time_ms += step_ms;
  for (std::size_t agent = 0; agent < trees.size(); ++agent) {
    if (state.left_ms[agent] != JointState::kForEver) state.left_ms[agent] -= step_ms;
  }
}

}  // namespace

JointState root_state(std::span<const std::int64_t> ready_ms) {
  assert(ready_ms.size() <= kMostAgents);
  JointState state;
  std::ranges::copy(ready_ms, state.left_ms.begin());
  return state;
}

std::size_t branching(const JointState& state, ActionTrees trees) {
  std::size_t product = 1;
  for (std::size_t agent = 0; agent < trees.size(); ++agent) {
    if (state.left_ms[agent] != 0) continue;
    product *= std::max<std::size_t>(1, ongoing(state, trees, agent).eligible.size());
  }
  return product;
}

JointState next_state(const JointState& state, ActionTrees trees,
                      const std::function<std::size_t(std::size_t agent, int action)>& choose) {
  JointState next = state;
  advance(next, trees, choose);
  return next;
}

bool is_final(const JointState& state, ActionTrees trees, std::int64_t horizon_ms) {
  if (state.time_ms >= horizon_ms) return true;
  for (std::size_t agent = 0; agent < trees.size(); ++agent) {
    if (state.left_ms[agent] == JointState::kForEver) continue;
    if (state.left_ms[agent] > 0 || !ongoing(state, trees, agent).eligible.empty()) return false;
  }
  return true;
}

JointState rollout(JointState state, ActionTrees trees, std::int64_t horizon_ms, Rng& rng) {
  const auto choose = [&](std::size_t agent, int action) {
    return drawn((*trees[agent])[static_cast<std::size_t>(action)].selection, rng);
  };
  while (!is_final(state, trees, horizon_ms)) advance(state, trees, choose);
  return state;
}

}  // namespace tandem
