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

TEST(Role, ANameMeansTheRoleThatBearsIt) {
  for (const Role role : {Role::LeaderFollower, Role::PeerPeer, Role::MasterSlave, Role::LeaderLeader}) {
    EXPECT_EQ(role_named(name_of(role)), role);
  }
  EXPECT_STREQ(name_of(Role::MasterSlave), "master_slave");
  EXPECT_FALSE(role_named("slave_master"));
}

}  // namespace
}  // namespace tandem
