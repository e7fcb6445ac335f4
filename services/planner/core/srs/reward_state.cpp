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

RewardState carried_over(const RewardState& state, const ResolvedWorld& from, const ResolvedWorld& to) {
  RewardState carried = initial_state(to);
  carried.time_s = state.time_s;
  for (std::size_t pool = 0; pool < to.pools().size(); ++pool) {
    for (const std::size_t source : to.pools()[pool].sources) {
      const auto before = index_of(from.world(), to.world().sources[source].id);
      if (!before) continue;
      const std::size_t old_pool = from.sources()[*before].pool;
      carried.drawn[pool] = state.drawn[old_pool];
      const double size = std::abs(to.pools()[pool].size);
      const bool same_size = size == std::abs(from.pools()[old_pool].size);
      carried.left[pool] = same_size ? state.left[old_pool] : std::max(0.0, size - state.drawn[old_pool]);
      break;
    }
  }
  for (std::size_t gate = 0; gate < to.gates().size(); ++gate) {
    const Relation& relation = to.world().relations[to.gates()[gate].relation];
    for (std::size_t old = 0; old < from.gates().size(); ++old) {
      if (from.world().relations[from.gates()[old].relation] == relation) carried.through[gate] = state.through[old];
    }
  }
  return carried;
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
