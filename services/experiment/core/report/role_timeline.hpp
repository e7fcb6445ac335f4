#pragma once

#include <array>
#include <span>
#include <vector>

#include "services/experiment/core/report/episode_log.hpp"

namespace tandem::experiment {

inline constexpr std::array kRoles{Role::LeaderFollower, Role::PeerPeer, Role::MasterSlave, Role::LeaderLeader};

/// A role that lasted.
struct RoleSpan {
  double from_s = 0.0;
  double to_s = 0.0;
  Role role = Role::LeaderFollower;
};

/// The roles of an episode from its first plan to its end: that of the newest plan that was made. A plan of another
/// search is not in the log.
[[nodiscard]] std::vector<RoleSpan> role_spans(const EpisodeLog& episode);

/// Time in each role over that in any, in the order of kRoles; all 0 without a plan.
[[nodiscard]] std::array<double, kRoles.size()> role_shares(const EpisodeLog& episode);

/// What the team is at one moment, over many episodes (paper 8.4.4, Fig. 24).
struct RolesAt {
  double time_s = 0.0;
  std::size_t ongoing = 0;                      ///< episodes that have not ended
  std::array<std::size_t, kRoles.size()> in{};  ///< of these, those in each role; the rest has no plan yet
};
/// At 0, `step_s`, ... until the last episode has ended.
[[nodiscard]] std::vector<RolesAt> roles_over_time(std::span<const EpisodeLog* const> episodes, double step_s);

}  // namespace tandem::experiment
