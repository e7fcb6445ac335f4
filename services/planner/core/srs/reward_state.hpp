#pragma once

#include <cstdint>
#include <vector>

#include "services/planner/core/srs/resolved_world.hpp"

namespace tandem {

/// What has happened to the pools and relations of a world: the whole state of an account, cheap to copy.
struct RewardState {
  std::vector<double> left;           ///< by pool, magnitude
  std::vector<double> drawn;          ///< by pool, magnitude; of an event: the probability that it has happened
  std::vector<std::uint8_t> through;  ///< by gate
  double time_s = 0.0;                ///< since the beginning

  bool operator==(const RewardState&) const = default;
};

/// Before anything has happened.
[[nodiscard]] RewardState initial_state(const ResolvedWorld& world);

/// The state of a world after an edit (9): what has gone from the pools of sources that are still there, and relations
/// that are through, stay so; what is new is fresh. Both worlds know a source, group or relation by its names.
[[nodiscard]] RewardState carried_over(const RewardState& state, const ResolvedWorld& from, const ResolvedWorld& to);

/// Whether a soft relation has silenced the source for the agent.
[[nodiscard]] bool is_silenced(const ResolvedSource& source, std::size_t agent, const ResolvedWorld& world,
                               const RewardState& state);

/// Whether all strict relations to the source are through.
[[nodiscard]] bool is_opened(const ResolvedSource& source, const RewardState& state);

/// Whether a reward of the sign of `per_s` takes from the pool (digest B3).
[[nodiscard]] inline bool takes_from(const ResolvedPool& pool, double per_s) {
  return pool.size * per_s > 0.0;
}

}  // namespace tandem
