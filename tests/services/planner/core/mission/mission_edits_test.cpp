#include <gtest/gtest.h>

#include <set>

#include "tests/services/planner/support/mission_in_hall.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;
using std::chrono::milliseconds;
using std::chrono::seconds;

using MissionEdits = MissionInHall;

const PlanarShape kRightEnd = Polygon{{{13, 0.5}, {16.5, 0.5}, {16.5, 10.5}, {13, 10.5}}};
const PlanarShape kNowhere = Disc{{90, 90}, 2.0};

SourceEdit drawn(SourceEdit::Kind kind, const PlanarShape& region, std::vector<std::string> targets = {}) {
  SourceEdit edit;
  edit.kind = kind;
  edit.source_id = "s1";
  edit.region = region;
  edit.targets = std::move(targets);
  return edit;
}

bool enters(const TimedPath& path, const PlanarShape& region) {
  for (double time_s = 0.0; time_s <= path.duration_s(); time_s += 0.1) {
    if (contains(region, pose_at(path, time_s).position())) return true;
  }
  return false;
}

TEST_F(MissionEdits, AHintChangesTheBeliefAndThePlan) {
  run();
  ASSERT_TRUE(plan());
  EXPECT_FALSE(mission.edit_belief({BeliefEdit::Kind::LikelyHere, kRightEnd, "very"}));
  const auto posterior = mission.belief()->posterior();
  const auto in = static_cast<std::size_t>(*mission.area()->cell_at({15, 5}));
  const auto out = static_cast<std::size_t>(*mission.area()->cell_at({10, 9}));
  EXPECT_NEAR(posterior[in] / posterior[out], 10.0, 1e-9);
  ASSERT_TRUE(plan());
  EXPECT_EQ(mission.plan()->reason, "the person knows something of where it is");
  EXPECT_FALSE(mission.step(now, kNeverOver));  // once is enough
}

TEST_F(MissionEdits, WhatThePersonSearchedIsTheirs) {
  run();
  ASSERT_TRUE(plan());
  const double before = mission.explored().by_agent[1];
  EXPECT_FALSE(mission.edit_belief({BeliefEdit::Kind::Searched, kRightEnd, "well"}));
  EXPECT_GT(mission.explored().by_agent[1], before + 0.15);
}

TEST_F(MissionEdits, AnEditThatMakesNoSenseIsRefusedAndNothingIsPlanned) {
  EXPECT_EQ(mission.edit_belief({BeliefEdit::Kind::NotHere, kRightEnd, ""}), "the search has not begun");
  run();
  ASSERT_TRUE(plan());
  EXPECT_EQ(mission.edit_belief({BeliefEdit::Kind::NotHere, kNowhere, ""}), "nothing is searched there");
  EXPECT_FALSE(mission.step(now, kNeverOver));
  mission.found();
  EXPECT_EQ(mission.edit_belief({BeliefEdit::Kind::NotHere, kRightEnd, ""}), "the search is over");
}

TEST_F(MissionEdits, AnEditWhileComputingBeginsAnew) {
  run();
  EXPECT_FALSE(mission.step(now, [] { return true; }));
  EXPECT_FALSE(mission.edit_belief({BeliefEdit::Kind::NotHere, kRightEnd, ""}));
  ASSERT_TRUE(plan());
  EXPECT_EQ(mission.plan()->reason, "first plan");
  EXPECT_FALSE(mission.step(now, kNeverOver));
}

TEST_F(MissionEdits, OneWhoKeepsEditingDoesNotKeepTheTeamFromMoving) {
  run();
  const PlanarShape left_end = Polygon{{{0.5, 0.5}, {4, 0.5}, {4, 10.5}, {0.5, 10.5}}};
  std::set<Time> read_from;  // one for each plan that is to be read anew
  std::optional<double> first_accepted_s;
  for (int i = 0; i < 200; ++i, pass(milliseconds{100})) {
    if (mission.step(now, kNeverOver)) read_from.insert(mission.plan()->start);
    const bool right = i / 5 % 2 == 0;  // they change their mind twice a second
    if (i % 5 == 0) {
      EXPECT_FALSE(mission.edit_belief({BeliefEdit::Kind::LikelyHere, right ? kRightEnd : left_end, "very"}));
    }
    if (!first_accepted_s && mission.standing(now) == PlanStanding::Accepted) first_accepted_s = 0.1 * i;
  }
  ASSERT_TRUE(first_accepted_s);
  EXPECT_LE(*first_accepted_s, 6.5);  // put off once
  EXPECT_LE(read_from.size(), 12U);   // two in each 4 s, not two a second
}

TEST_F(MissionEdits, WhatIsEditedWhileEditsWaitMakesOnePlan) {
  run();
  ASSERT_TRUE(plan());
  EXPECT_FALSE(mission.edit_belief({BeliefEdit::Kind::LikelyHere, kRightEnd, "very"}));
  ASSERT_TRUE(plan());
  ASSERT_FALSE(mission.plan()->start == now) << "the second plan was to be another one";
  const std::string read = mission.plan()->id;
  for (int i = 0; i < 29; ++i, pass(milliseconds{100})) {
    if (i == 5) {
      EXPECT_FALSE(mission.edit_belief({BeliefEdit::Kind::NotHere, Disc{{10, 8}, 1.0}, ""}));
    }
    if (i == 9) {
      EXPECT_FALSE(mission.edit_source(drawn(SourceEdit::Kind::GoTo, Disc{{8, 2}, 1.0}, {"person"}), now));
    }
    EXPECT_FALSE(mission.step(now, kNeverOver)) << i;
  }
  EXPECT_EQ(mission.plan()->id, read);
  EXPECT_EQ(mission.standing(now + milliseconds{200}), PlanStanding::Accepted);
  ASSERT_TRUE(plan());
  EXPECT_EQ(mission.plan()->role, Role::PeerPeer);  // knows of the goal
  EXPECT_FALSE(mission.step(now, kNeverOver));      // and of the rest
}

TEST_F(MissionEdits, APlanThatBeginsLikeTheOneBeingReadIsAcceptedWhenThatWouldHaveBeen) {
  PlannerConfig first_plans = config();
  first_plans.rollouts = 0;  // nothing is found by chance
  SearchMission steady(first_plans, "robot", "person");
  steady.set_map(empty_room(16, 10));
  const auto plan_at = [&](Duration later) {
    now += later;
    steady.robot_at(now, robot);
    steady.person_at(now, person, 0.0);
    return steady.step(now, kNeverOver);
  };
  EXPECT_FALSE(plan_at(seconds{0}));
  steady.run_session("s1", now);
  ASSERT_TRUE(plan_at(seconds{0}));
  const std::string id = steady.plan()->id;
  const Time accepted = steady.plan()->start;
  for (int i = 0; i < 2; ++i) {  // however often
    EXPECT_FALSE(steady.edit_belief({BeliefEdit::Kind::NotHere, Disc{{16, 10}, 0.8}, i == 0 ? "a bit" : "quite"}));
    ASSERT_TRUE(plan_at(seconds{1}));
    EXPECT_NE(steady.plan()->id, id);
    EXPECT_EQ(steady.plan()->start, accepted);
  }
  EXPECT_EQ(steady.standing(accepted), PlanStanding::Accepted);
}

TEST_F(MissionEdits, EditsFasterThanComputingCutItShortOnce) {
  run();
  const auto slice = [rollouts = 0]() mutable { return ++rollouts % 5 == 0; };
  int slices = 0;
  for (; slices < 100 && !mission.step(now, slice); ++slices, pass(milliseconds{100})) {
    EXPECT_FALSE(mission.edit_belief({BeliefEdit::Kind::LikelyHere, kRightEnd, slices % 2 == 0 ? "very" : "a bit"}));
  }
  EXPECT_LT(slices, 20);
  const std::string first = mission.plan()->id;
  ASSERT_TRUE(plan());  // the words it did not know of are not lost
  EXPECT_NE(mission.plan()->id, first);
}

TEST_F(MissionEdits, APlanIntoWhatIsNowForbiddenIsWithdrawnAtOnce) {
  run();
  ASSERT_TRUE(plan());
  pass(seconds{4});
  ASSERT_EQ(mission.standing(now), PlanStanding::Accepted);
  const Vector2d ahead = pose_at(paths()[0], 10.0).position();
  EXPECT_FALSE(mission.edit_source(drawn(SourceEdit::Kind::Avoid, Disc{ahead, 0.5}), now));
  EXPECT_EQ(mission.standing(now), PlanStanding::Superseded);
  ASSERT_TRUE(plan());
  EXPECT_EQ(mission.plan()->reason, "the person drew on the map");
}

TEST_F(MissionEdits, NobodyWalksWhereEverybodyIsKeptOut) {
  run();
  ASSERT_TRUE(plan());
  const PlanarShape middle = Polygon{{{7, 2}, {10, 2}, {10, 8}, {7, 8}}};
  EXPECT_FALSE(mission.edit_source(drawn(SourceEdit::Kind::Avoid, middle), now));
  EXPECT_EQ(mission.sources().size(), 1U);
  ASSERT_TRUE(plan());
  EXPECT_EQ(mission.plan()->reason, "the person drew on the map");
  for (const auto& path : paths()) EXPECT_FALSE(enters(path, middle));

  SourceEdit gone;
  gone.source_id = "s1";
  EXPECT_FALSE(mission.edit_source(gone, now));
  EXPECT_TRUE(mission.sources().empty());
  ASSERT_TRUE(plan());
  EXPECT_TRUE(enters(paths()[0], middle) || enters(paths()[1], middle));
  EXPECT_EQ(mission.edit_source(gone, now), "nothing of this id is drawn");
}

TEST_F(MissionEdits, OnlyWhomItConcernsIsKeptOut) {
  run();
  EXPECT_FALSE(mission.edit_source(drawn(SourceEdit::Kind::Avoid, kRightEnd, {"robot"}), now));
  ASSERT_TRUE(plan());
  EXPECT_FALSE(enters(paths()[0], kRightEnd));
  EXPECT_TRUE(enters(paths()[1], kRightEnd));
}

TEST_F(MissionEdits, NobodyIsKeptOutOfWhereTheyStandOrShutIn) {
  run();
  EXPECT_EQ(mission.edit_source(drawn(SourceEdit::Kind::Avoid, Disc{{3, 3}, 0.5}), now), "robot stands there");
  EXPECT_FALSE(mission.edit_source(drawn(SourceEdit::Kind::Avoid, Disc{{12, 5}, 0.5}), now));
  const PlanarShape all_but_here = Polygon{{{0, 0},
                                            {17, 0},
                                            {17, 11},
                                            {0, 11},
                                            {0, 3.1},
                                            {2.7, 3.1},
                                            {2.7, 3.3},
                                            {3.3, 3.3},
                                            {3.3, 2.7},
                                            {2.7, 2.7},
                                            {2.7, 2.9},
                                            {0, 2.9}}};
  SourceEdit shut_in = drawn(SourceEdit::Kind::Avoid, all_but_here, {"robot"});
  shut_in.source_id = "s2";
  const auto refusal = mission.edit_source(shut_in, now);
  EXPECT_EQ(refusal, "robot would not get anywhere any more");
  EXPECT_EQ(mission.sources().size(), 1U);
  ASSERT_TRUE(plan());
  EXPECT_GT(paths()[0].duration_s(), 5.0);
}

TEST_F(MissionEdits, APlaceToGoToIsAGoalUntilItIsReachedOrRemoved) {
  run();
  EXPECT_FALSE(mission.edit_source(drawn(SourceEdit::Kind::GoTo, Disc{{8, 2}, 1.0}, {"person"}), now));
  ASSERT_EQ(mission.sources().size(), 2U);
  ASSERT_EQ(mission.relations().size(), 1U);
  EXPECT_EQ(mission.relations()[0].to, mission.sources()[0].id);
  ASSERT_TRUE(plan());
  EXPECT_EQ(mission.plan()->role, Role::PeerPeer);
  carry_out(seconds{20});
  ASSERT_TRUE(plan());
  EXPECT_TRUE(mission.sources().empty());

  EXPECT_FALSE(mission.edit_source(drawn(SourceEdit::Kind::GoTo, Disc{{12, 8}, 1.0}, {"robot"}), now));
  EXPECT_TRUE(mission.goal(SearchMission::kRobot));
  SourceEdit gone;
  gone.source_id = "s1";
  EXPECT_FALSE(mission.edit_source(gone, now));
  EXPECT_FALSE(mission.goal(SearchMission::kRobot));
}

TEST_F(MissionEdits, AnIdIsGivenOnce) {
  run();
  EXPECT_FALSE(mission.edit_source(drawn(SourceEdit::Kind::Avoid, kRightEnd), now));
  EXPECT_EQ(mission.edit_source(drawn(SourceEdit::Kind::Avoid, kRightEnd), now),
            "there is a source of this id already");
}

TEST_F(MissionEdits, ANewSearchBeginsWithNothingDrawn) {
  run();
  EXPECT_FALSE(mission.edit_source(drawn(SourceEdit::Kind::Avoid, kRightEnd), now));
  EXPECT_FALSE(mission.edit_belief({BeliefEdit::Kind::LikelyHere, kRightEnd, "very"}));
  mission.run_session("s2", now);
  EXPECT_TRUE(mission.sources().empty());
  ASSERT_TRUE(plan());
  EXPECT_EQ(mission.plan()->reason, "first plan");
  EXPECT_TRUE(enters(paths()[0], kRightEnd) || enters(paths()[1], kRightEnd));
}

TEST_F(MissionEdits, APersonGoesOnForAMomentBeforeTheyTurnToAPlanTheyDidNotAskFor) {
  run();
  ASSERT_TRUE(plan());
  carry_out(seconds{12});
  const TimedPath old = paths()[1];
  const double elapsed_s = to_seconds(now - mission.plan()->start);
  auto done = progress();
  done.finished = true;
  mission.robot_progress(done, now);
  ASSERT_TRUE(mission.step(now, kNeverOver));
  const TimedPath next = paths()[1];
  for (double time_s = 0.0; time_s < 3.0; time_s += 0.5) {
    const Vector2d there = pose_at(old, elapsed_s + time_s).position();
    EXPECT_LT((pose_at(next, time_s).position() - there).norm(), 0.8) << time_s;
  }
  carry_out(seconds{12});
  EXPECT_FALSE(mission.request({PersonRequest::Kind::Replan, {}}, now));
  ASSERT_TRUE(mission.step(now, kNeverOver));  // this one they asked for; it begins where they stand
  EXPECT_LT((paths()[1].points[0].point_in_map - person.position()).norm(), 0.3);
}

TEST_F(MissionEdits, APlanIsExplained) {
  run();
  ASSERT_TRUE(plan());
  EXPECT_TRUE(mission.plan()->explanation.starts_with("First plan. The robot goes ")) << mission.plan()->explanation;
  EXPECT_NE(mission.plan()->explanation.find("if you stayed where you are"), std::string::npos);
}

}  // namespace
}  // namespace tandem
