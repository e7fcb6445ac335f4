#include "services/planner/core/srs/mental_model.hpp"

#include <algorithm>

namespace tandem {

bool knows(const RewardWorld& world, const std::string& agent, const std::string& source_id) {
  const auto unaware = std::ranges::find(world.unawareness, agent, &Unawareness::agent);
  return unaware == world.unawareness.end() || std::ranges::count(unaware->sources, source_id) == 0;
}

RewardWorld world_as_known_by(const RewardWorld& world, const std::string& agent) {
  RewardWorld known = world;
  for (const auto& source : world.sources) {
    if (!knows(world, agent, source.id)) remove_source(known, source.id);
  }
  known.version = world.version;
  return known;
}

std::vector<Inform> possible_informs(const RewardWorld& world) {
  std::vector<Inform> informs;
  for (const auto& agent : world.agents) {
    for (const auto& source : world.sources) {
      if (!knows(world, agent, source.id)) informs.push_back({agent, source.id});
    }
  }
  return informs;
}

RewardWorld informed(RewardWorld world, const Inform& inform) {
  for (auto& unaware : world.unawareness) {
    if (unaware.agent == inform.agent && std::erase(unaware.sources, inform.source) > 0) ++world.version;
  }
  std::erase_if(world.unawareness, [](const Unawareness& unaware) { return unaware.sources.empty(); });
  return world;
}

}  // namespace tandem
