#include <gtest/gtest.h>

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
