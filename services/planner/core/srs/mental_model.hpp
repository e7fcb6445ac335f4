#pragma once

#include <string>
#include <vector>

#include "services/planner/core/srs/reward_world.hpp"

namespace tandem {

/// Telling an agent about a source: it knows it afterwards (paper 3.4, digest D3).
struct Inform {
  std::string agent;
  std::string source;
  bool operator==(const Inform&) const = default;
};

/// Whether the agent is believed to know the source.
[[nodiscard]] bool knows(const RewardWorld& world, const std::string& agent, const std::string& source_id);

/// The world as the agent is believed to see it: without the sources that it does not know and their relations. Others'
/// behaviour is predicted from this; the joint value always comes from the whole world (digest D2).
[[nodiscard]] RewardWorld world_as_known_by(const RewardWorld& world, const std::string& agent);

/// All that could be told, by agent, then by source, as listed.
[[nodiscard]] std::vector<Inform> possible_informs(const RewardWorld& world);

/// The world after telling. The cost of the message, `message_cost`, is the caller's to subtract.
[[nodiscard]] RewardWorld informed(RewardWorld world, const Inform& inform);

}  // namespace tandem
