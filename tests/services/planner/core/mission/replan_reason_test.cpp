#include "services/planner/core/mission/replan_reason.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

/// A plan under way for a minute that goes as it should.
PlanSituation under_way() {
  PlanSituation situation;
  situation.standing = PlanStanding::Accepted;
  situation.age_s = 60.0;
  return situation;
}

TEST(ReplanReason, APlanThatGoesAsItShouldIsKept) {
  EXPECT_EQ(replan_reason(under_way(), {}), std::nullopt);
}

TEST(ReplanReason, WithoutAPlanThatStandsThereIsAlwaysOne) {
  for (const auto standing :
       {PlanStanding::None, PlanStanding::Rejected, PlanStanding::Superseded, PlanStanding::Expired}) {
    PlanSituation situation;
    situation.standing = standing;
    EXPECT_TRUE(replan_reason(situation, {})) << static_cast<int>(standing);
  }
}

TEST(ReplanReason, WhatThePersonSaysCannotWait) {
  PlanSituation situation = under_way();
  situation.age_s = 4.0;  // accepted at 3 s
  situation.person_drew = true;
  EXPECT_EQ(replan_reason(situation, {}), "the person drew on the map");
  situation.person_said_where = true;
  EXPECT_EQ(replan_reason(situation, {}), "the person knows something of where it is");
}

TEST(ReplanReason, EditsWaitForAnAcceptanceThatEditsHavePutOffOnce) {
  PlanSituation situation = under_way();
  situation.standing = PlanStanding::Proposed;
  situation.person_said_where = true;
  EXPECT_TRUE(replan_reason(situation, {}));
  situation.edits_must_wait = true;
  EXPECT_EQ(replan_reason(situation, {}), std::nullopt);
  situation.standing = PlanStanding::Accepted;
  situation.age_s = 3.9;
  EXPECT_EQ(replan_reason(situation, {}), std::nullopt);  // the robot may not have heard of it
  situation.age_s = 4.0;
  EXPECT_TRUE(replan_reason(situation, {}));
}

TEST(ReplanReason, ABlockedPathCannotWait) {
  PlanSituation situation = under_way();
  situation.age_s = 0.0;
  situation.blocked = true;
  EXPECT_EQ(replan_reason(situation, {}), "the robot's path is blocked");
}

TEST(ReplanReason, TheEndOfAPathCountsOnlyOnceThePlanIsAccepted) {
  PlanSituation situation = under_way();
  situation.robot_finished = true;
  EXPECT_EQ(replan_reason(situation, {}), "the robot is at the end of its path");
  situation.standing = PlanStanding::Proposed;
  EXPECT_EQ(replan_reason(situation, {}), std::nullopt);
}

TEST(ReplanReason, ASurpriseIsNoReasonBeforeThePauseIsOver) {
  PlannerConfig config;
  config.replan_pause_s = 20.0;
  config.surprise = 0.15;
  PlanSituation situation = under_way();
  situation.surprise = 0.2;
  situation.age_s = 19.0;
  EXPECT_EQ(replan_reason(situation, config), std::nullopt);
  situation.age_s = 20.0;
  EXPECT_EQ(replan_reason(situation, config), "less was seen than planned");
  situation.surprise = 0.1;
  EXPECT_EQ(replan_reason(situation, config), std::nullopt);
}

TEST(ReplanReason, APersonWhoGoesAnotherWayForLongIsFollowed) {
  PlannerConfig config;
  config.deviation_s = 10.0;
  PlanSituation situation = under_way();
  situation.person_off_plan_s = 9.0;
  EXPECT_EQ(replan_reason(situation, config), std::nullopt);
  situation.person_off_plan_s = 11.0;
  EXPECT_EQ(replan_reason(situation, config), "the person went another way");
}

TEST(ReplanReason, ARobotThatIsAheadOfThePersonGetsBehindButNotAllTheTime) {
  PlanSituation situation = under_way();
  situation.robot_is_ahead = true;
  EXPECT_EQ(replan_reason(situation, {}), "the robot is ahead of the person");
  situation.age_s = 19.0;
  EXPECT_EQ(replan_reason(situation, {}), std::nullopt);
}

}  // namespace
}  // namespace tandem
