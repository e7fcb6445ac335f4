#include "services/planner/core/srs/reward_state.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {

RewardState initial_state(const ResolvedWorld& world) {
  RewardState state;
  for (const auto& pool : world.pools()) state.left.push_back(std::abs(pool.size));
  state.drawn.assign(world.pools().size(), 0.0);
  state.through.assign(world.gates().size(), 0);
  return state;
}

bool is_silenced(const ResolvedSource& source, std::size_t agent, const ResolvedWorld& world,
                 const RewardState& state) {
  return std::ranges::any_of(source.silenced_by, [&](std::size_t gate) {
    return state.through[gate] != 0 && (world.gates()[gate].agents & mask_of(agent)) != 0;
  });
}

bool is_opened(const ResolvedSource& source, const RewardState& state) {
  return std::ranges::all_of(source.opened_by, [&](std::size_t gate) { return state.through[gate] != 0; });
}

}  // namespace tandem
