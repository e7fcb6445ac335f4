#include "services/planner/core/srs/reward_account.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/services/planner/support/sources.hpp"

namespace tandem {
namespace {

AgentMove at(double x, double y = 0.0) {
  return stay_at({x, y});
}

TEST(RewardAccount, ReportsTheInstantAPoolRunsDryAndWhoDrew) {
  Course course{world_of({"a", "b"}, {disc_source("s", {0, 0}, 1.0, 2.0, 6.0)})};

  course.advance({at(0), at(9)}, 1.0);  // 2 of 6
  course.advance({at(0), at(0)}, 3.0);  // the other 4 at 4 per s
  ASSERT_EQ(course.record().events.size(), 1u);
  EXPECT_EQ(course.record().events[0].kind, RewardEvent::Kind::Exhausted);
  EXPECT_NEAR(course.record().events[0].time_s, 2.0, 1e-12);
  EXPECT_EQ(course.record().events[0].agents, mask_of(0) | mask_of(1));
  EXPECT_DOUBLE_EQ(course.record().paid[0], 4.0);
  EXPECT_DOUBLE_EQ(course.record().paid[1], 2.0);
}

TEST(RewardAccount, RewardOfTheOtherSignThanThePoolIsWithoutLimit) {
  RewardSource fire = disc_source("goal_in_smoke", {0, 0}, 1.0, 5.0, 5.0);
  fire.outside = constant_ratio(-1.0);
  Course course{world_of({"a"}, {fire})};

  EXPECT_DOUBLE_EQ(course.advance({at(0)}, 3.0)[0], 5.0);
  EXPECT_DOUBLE_EQ(course.advance({at(9)}, 3.0)[0], -3.0);
  EXPECT_DOUBLE_EQ(course.advance({at(0)}, 3.0)[0], 0.0);  // empty
  EXPECT_DOUBLE_EQ(course.advance({at(9)}, 3.0)[0], -3.0);
}

TEST(RewardAccount, WhatADrawIsWorthDoesNotChangeWhatLeavesThePool) {
  RewardSource source = disc_source("s", {0, 0}, 1.0, 2.0, 4.0);
  source.tempers = {{"keen", 1.0, 3.0}};
  Course course{world_of({"keen", "b"}, {source})};

  EXPECT_DOUBLE_EQ(course.advance({at(0), absent()}, 1.0)[0], 6.0);  // 2 units of 3
  EXPECT_DOUBLE_EQ(course.account().left(0), 2.0);
}

TEST(RewardAccount, AFastAgentDrawsFasterFromTheSamePool) {
  RewardSource source = disc_source("s", {0, 0}, 1.0, 1.0, 8.0);
  source.tempers = {{"fast", 3.0, 1.0}};
  Course course{world_of({"fast", "slow"}, {source})};

  const auto rewards = course.advance({at(0), at(0)}, 5.0);  // empty after 2 s
  EXPECT_NEAR(rewards[0], 6.0, 1e-12);
  EXPECT_NEAR(rewards[1], 2.0, 1e-12);
}

TEST(RewardAccount, AnyConsumedSuccessorSilencesAndAllPredecessorsAreNeeded) {
  const RewardWorld world =
      world_of({"a"},
               {disc_source("x", {0, 0}, 1, 1, 1), disc_source("y", {5, 0}, 1, 1, 1),
                disc_source("both", {10, 0}, 1, 1, 1), disc_source("either", {15, 0}, 1, 1, 1)},
               {strict("x", "both"), strict("y", "both"), soft("either", "x"), soft("either", "y")});
  Course course{world};
  course.advance({at(0)}, 1.0);
  EXPECT_DOUBLE_EQ(course.advance({at(10)}, 1.0)[0], 0.0);  // y is still there
  EXPECT_DOUBLE_EQ(course.advance({at(15)}, 1.0)[0], 0.0);  // x alone silences
  course.advance({at(5)}, 1.0);
  EXPECT_DOUBLE_EQ(course.advance({at(10)}, 1.0)[0], 1.0);
}

TEST(RewardAccount, ARelationTakesEffectAtTheInstantItsPredecessorIsConsumed) {
  // a empties the switch after 2 of 5 s; b stands at the panel all the time.
  Course course{world_of({"a", "b"}, {disc_source("switch", {0, 0}, 1, 1, 2), disc_source("panel", {9, 0}, 1, 10)},
                         {strict("switch", "panel")})};
  EXPECT_NEAR(course.advance({at(0), at(9)}, 5.0)[1], 30.0, 1e-12);
}

TEST(RewardAccount, ATriggerMayBeAPartOfThePoolAnAmountOrAnEntry) {
  const auto reward_after = [](Trigger trigger, double pool) {
    RewardWorld world = world_of({"a", "b"}, {disc_source("key", {0, 0}, 1, 1, 4), disc_source("door", {9, 0}, 1, 1)},
                                 {strict("key", "door")});
    world.sources[0].pool = pool;
    world.relations[0].trigger = trigger;
    Course course{world};
    return course.advance({straight_move({-2, 0}, {8, 0}), at(9)}, 10.0)[1];  // a is inside from 1 s to 3 s
  };
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  EXPECT_DOUBLE_EQ(reward_after({Trigger::Kind::Fraction, 1.0}, 4.0), 0.0);  // a draws but 2 of 4
  EXPECT_NEAR(reward_after({Trigger::Kind::Fraction, 0.25}, 4.0), 8.0, 1e-12);
  EXPECT_NEAR(reward_after({Trigger::Kind::Amount, 1.5}, kNoLimit), 7.5, 1e-12);
  EXPECT_NEAR(reward_after({Trigger::Kind::Entry, 1.0}, kNoLimit), 9.0, 1e-12);
}

TEST(RewardAccount, ComesBackToAStateItHasKept) {
  Course course{world_of({"a"}, {disc_source("s", {0, 0}, 1.0, 1.0, 3.0)})};
  course.advance({at(0)}, 1.0);
  const RewardState kept = course.account().state();

  const double first = course.advance({at(0)}, 5.0)[0];
  course.account().restore(kept);
  EXPECT_EQ(course.account().state(), kept);
  EXPECT_DOUBLE_EQ(course.advance({at(0)}, 5.0)[0], first);
}

TEST(RewardAccount, NobodyDrawsWithAnAbsentAgent) {
  RewardSource beside;
  beside.id = "beside";
  beside.boundary = Attached{"person", Disc{{0, 1}, 0.5}};
  beside.inside = constant_ratio(1.0);
  Course course{world_of({"robot", "person"}, {beside})};

  EXPECT_DOUBLE_EQ(course.advance({at(0, 1), at(0, 0)}, 2.0)[0], 2.0);
  EXPECT_DOUBLE_EQ(course.advance({at(0, 1), absent()}, 2.0)[0], 0.0);
}

TEST(RewardAccount, TheOwnerOfABoundaryIsNoTargetUnlessListed) {
  RewardSource around;
  around.id = "around";
  around.boundary = Attached{"person", Disc{{0, 0}, 2.0}};
  around.inside = constant_ratio(1.0);
  EXPECT_DOUBLE_EQ((Course{world_of({"robot", "person"}, {around})}.advance({at(9), at(0)}, 1.0)[1]), 0.0);
  around.targets = {"person"};
  EXPECT_DOUBLE_EQ((Course{world_of({"robot", "person"}, {around})}.advance({at(9), at(0)}, 1.0)[1]), 1.0);
}

}  // namespace
}  // namespace tandem
