#pragma once

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

}  // namespace tandem
