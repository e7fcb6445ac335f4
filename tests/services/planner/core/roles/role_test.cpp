#include "services/planner/core/roles/role.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

TEST(Role, FollowsFromWhoseGoalsThePersonFixed) {
  EXPECT_EQ(role_of(false, false), Role::LeaderFollower);
  EXPECT_EQ(role_of(true, false), Role::PeerPeer);
  EXPECT_EQ(role_of(true, true), Role::MasterSlave);
  EXPECT_EQ(role_of(false, true), Role::LeaderLeader);
}

}  // namespace
}  // namespace tandem
