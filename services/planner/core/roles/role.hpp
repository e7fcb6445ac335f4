#pragma once

#include <optional>
#include <string_view>

namespace tandem {

/// Who leads, as follows from whose goals a person has fixed (paper 6, digest 1.4).
enum class Role {
  LeaderFollower,  ///< no goal: the robot leads, the person follows and may veto
  PeerPeer,        ///< the person's own goal
  MasterSlave,     ///< both goals
  LeaderLeader,    ///< the robot's goal alone
};

/// The role for a plan in which the person's and the robot's goal are fixed, or not.
[[nodiscard]] constexpr Role role_of(bool person_goal_fixed, bool robot_goal_fixed) {
  if (person_goal_fixed) return robot_goal_fixed ? Role::MasterSlave : Role::PeerPeer;
  return robot_goal_fixed ? Role::LeaderLeader : Role::LeaderFollower;
}

/// A role as it is called in files: leader_follower, ...
[[nodiscard]] constexpr const char* name_of(Role role) {
  switch (role) {
    case Role::LeaderFollower:
      return "leader_follower";
    case Role::PeerPeer:
      return "peer_peer";
    case Role::MasterSlave:
      return "master_slave";
    case Role::LeaderLeader:
      break;
  }
  return "leader_leader";
}

/// The role that name_of() calls so, if there is one.
[[nodiscard]] constexpr std::optional<Role> role_named(std::string_view name) {
  for (const Role role : {Role::LeaderFollower, Role::PeerPeer, Role::MasterSlave, Role::LeaderLeader}) {
    if (name_of(role) == name) return role;
  }
  return std::nullopt;
}

}  // namespace tandem
