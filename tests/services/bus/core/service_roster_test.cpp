#include "services/bus/core/service_roster.hpp"

#include <gtest/gtest.h>

namespace tandem::bus {
namespace {

using std::chrono::seconds;

ServiceSign sign(const std::string& host, const std::string& service, std::uint32_t process_id) {
  return {host, service, "robot1", process_id, "1.0.0", "abc", "ok", ""};
}

Time at(int second) {
  return Time{} + seconds{second};
}

TEST(ServiceRoster, X5TwoPlannersOfOneRobotAreNamedWithTheirHosts) {
  ServiceRoster roster;
  for (int second = 0; second < 2; ++second) {
    roster.heard(sign("laptop1", "planner", 12), at(2 * second));
    roster.heard(sign("laptop2", "planner", 34), at(2 * second + 1));
  }
  ASSERT_EQ(roster.doubles(at(3)).size(), 1U);
  EXPECT_EQ(text_of(roster.doubles(at(3))[0]),
            "X5: two planner services for robot1: process 12 on host laptop1, and process 34 on host laptop2; end one, "
            "or rename its robot");
  EXPECT_TRUE(roster.double_of(sign("laptop1", "planner", 12), at(3)));
  EXPECT_TRUE(roster.double_of(sign("laptop2", "planner", 34), at(3)));
  EXPECT_FALSE(roster.double_of(sign("laptop1", "relay", 5), at(3)));
}

TEST(ServiceRoster, X6TwoBasesOfOneRobotAreARobotTooMany) {
  ServiceRoster roster;
  roster.heard(sign("robot1", "base", 12), at(0));
  roster.heard(sign("robot1b", "base", 12), at(1));
  EXPECT_TRUE(roster.doubles(at(1)).empty());  // the second may have taken the first one's place
  roster.heard(sign("robot1", "base", 12), at(2));
  ASSERT_EQ(roster.doubles(at(2)).size(), 1U);
  EXPECT_EQ(roster.doubles(at(2))[0].id, "X6");
}

TEST(ServiceRoster, OneThatWasStartedAgainIsOne) {
  ServiceRoster roster;
  roster.heard(sign("robot1", "base", 12), at(0));
  roster.heard(sign("robot1", "base", 12), at(1));
  roster.heard(sign("robot1", "base", 13), at(2));
  roster.heard(sign("robot1", "base", 13), at(3));
  EXPECT_TRUE(roster.doubles(at(3)).empty());
}

TEST(ServiceRoster, EachHostHasARelayOfItsOwn) {
  ServiceRoster roster;
  for (int second = 0; second < 4; ++second) {
    roster.heard(sign("robot1", "relay", 12), at(second));
    roster.heard(sign("laptop1", "relay", 13), at(second));
  }
  EXPECT_TRUE(roster.doubles(at(3)).empty());
}

TEST(ServiceRoster, TheSilentAreGone) {
  ServiceRoster roster;
  roster.heard(sign("robot1", "base", 12), at(0));
  roster.heard(sign("robot1", "laser", 13), at(3));
  EXPECT_EQ(roster.alive(at(3)).size(), 2U);
  EXPECT_EQ(roster.alive(at(4)).size(), 1U);
  EXPECT_TRUE(roster.alive(at(7)).empty());
}

TEST(ServiceRoster, X7AnotherContractIsNamedWithARemedy) {
  ServiceRoster roster;
  roster.heard(sign("robot1", "base", 12), at(0));
  ServiceSign old = sign("robot1", "laser", 13);
  old.version = "0.9.0";
  old.contract_hash = "def";
  roster.heard(old, at(0));
  ASSERT_EQ(roster.other_contracts("robot1", "abc", at(0)).size(), 1U);
  EXPECT_EQ(text_of(roster.other_contracts("", "abc", at(0))[0]),
            "X7: laser on host robot1 runs another version (0.9.0): its contract is def, ours abc; install the same "
            "release on all hosts");
  EXPECT_TRUE(roster.other_contracts("laptop1", "abc", at(0)).empty());
}

}  // namespace
}  // namespace tandem::bus
