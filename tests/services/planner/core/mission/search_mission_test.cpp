#include "services/planner/core/mission/search_mission.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/mission_in_hall.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;
using std::chrono::milliseconds;
using std::chrono::seconds;

using SearchMissionTest = MissionInHall;

TEST_F(SearchMissionTest, PlansNothingBeforeTheSessionRuns) {
  for (int i = 0; i < 10; ++i, pass(seconds{1})) EXPECT_FALSE(mission.step(now, kNeverOver));
  EXPECT_FALSE(mission.plan());
  run();
  EXPECT_TRUE(plan());
  EXPECT_EQ(mission.standing(now), PlanStanding::Proposed);
}

TEST_F(SearchMissionTest, APlanStartsWhereBothStandWhenItIsAccepted) {
  run();
  ASSERT_TRUE(plan());
  EXPECT_EQ(mission.plan()->start, now + seconds{3});
  EXPECT_NEAR((mission.plan()->members[0].path.points[0].point_in_map - robot.position()).norm(), 0.0, 0.3);
  EXPECT_NEAR((mission.plan()->members[1].path.points[0].point_in_map - person.position()).norm(), 0.0, 0.3);
  pass(seconds{3});
  EXPECT_EQ(mission.standing(now), PlanStanding::Accepted);
}

TEST_F(SearchMissionTest, ComputesInSlices) {
  run();
  EXPECT_FALSE(mission.step(now, [] { return true; }));  // no time at all
  EXPECT_EQ(mission.activity(), MissionActivity::Computing);
  EXPECT_EQ(mission.progress(), 0.0);
  int rollouts = 0;
  EXPECT_FALSE(mission.step(now, [&] { return rollouts++ == 10; }));
  EXPECT_DOUBLE_EQ(mission.progress(), 0.5);
  EXPECT_TRUE(mission.step(now, kNeverOver));
  EXPECT_EQ(mission.activity(), MissionActivity::Idle);
}

TEST_F(SearchMissionTest, APlanIsOutBeforeItsLowerBoundIsFound) {
  run();
  EXPECT_FALSE(mission.certify());
  ASSERT_TRUE(plan());
  EXPECT_EQ(mission.plan()->lower_bound_s, 0.0);
  EXPECT_TRUE(mission.certify());
  EXPECT_GT(mission.plan()->lower_bound_s, 0.0);
  EXPECT_LE(mission.plan()->lower_bound_s, mission.plan()->forecast.expected_time_s);
  EXPECT_FALSE(mission.certify());  // once is enough
}

TEST_F(SearchMissionTest, ReplanRejectsTheProposalAndTheNextPlanDiffers) {
  run();
  ASSERT_TRUE(plan());
  const auto rejected = paths();
  EXPECT_FALSE(mission.request({PersonRequest::Kind::Replan, {}}, now));
  EXPECT_EQ(mission.standing(now), PlanStanding::Rejected);
  ASSERT_TRUE(plan());
  EXPECT_FALSE(is_like(paths(), rejected));
}

TEST_F(SearchMissionTest, GoalsAreInTheNextPlanAndMakeTheRole) {
  run();
  EXPECT_FALSE(mission.request({PersonRequest::Kind::MyGoal, {15, 9}}, now));
  ASSERT_TRUE(plan());
  EXPECT_EQ(mission.plan()->role, Role::PeerPeer);
  EXPECT_TRUE(mission.plan()->members[1].goal_fixed);
  EXPECT_LE((mission.plan()->members[1].goal_in_map - Vector2d{15, 9}).norm(), 0.5);

  EXPECT_FALSE(mission.request({PersonRequest::Kind::RobotGoal, {3, 9}}, now));
  EXPECT_FALSE(mission.request({PersonRequest::Kind::Replan, {}}, now));
  ASSERT_TRUE(plan());
  EXPECT_EQ(mission.plan()->role, Role::MasterSlave);

  EXPECT_FALSE(mission.request({PersonRequest::Kind::ClearMyGoal, {}}, now));
  EXPECT_FALSE(mission.request({PersonRequest::Kind::Replan, {}}, now));
  ASSERT_TRUE(plan());
  EXPECT_EQ(mission.plan()->role, Role::LeaderLeader);
}

TEST_F(SearchMissionTest, AGoalOutsideTheMapIsRefusedWithAReason) {
  mission.step(now, kNeverOver);
  EXPECT_TRUE(mission.request({PersonRequest::Kind::MyGoal, {50, 50}}, now));
  EXPECT_FALSE(mission.goal(SearchMission::kPerson));
}

TEST_F(SearchMissionTest, AReachedGoalIsForgottenAndThePlanGoesOn) {
  run();
  EXPECT_FALSE(mission.request({PersonRequest::Kind::MyGoal, {8, 2}}, now));
  ASSERT_TRUE(plan());
  carry_out(seconds{20});
  ASSERT_TRUE(plan());
  EXPECT_FALSE(mission.goal(SearchMission::kPerson));
  EXPECT_EQ(mission.plan()->reason, "the person reached their goal");
}

TEST_F(SearchMissionTest, WhenThePathIsFinishedThereIsANewPlan) {
  run();
  ASSERT_TRUE(plan());
  carry_out(seconds{10});
  EXPECT_FALSE(mission.step(now, kNeverOver));
  auto done = progress();
  done.finished = true;
  mission.robot_progress(done, now);
  EXPECT_TRUE(mission.step(now, kNeverOver));
}

TEST_F(SearchMissionTest, ABlockedPathIsPlannedAround) {
  run();
  ASSERT_TRUE(plan());
  carry_out(seconds{5});
  const Vector2d ahead =
      pose_at(mission.plan()->members[0].path, to_seconds(now - mission.plan()->start) + 3.0).position();
  auto blocked = progress();
  blocked.blocked = true;
  blocked.blocked_at_in_map = ahead;
  mission.robot_progress(blocked, now);
  EXPECT_FALSE(mission.step(now, kNeverOver));  // it may pass
  pass(seconds{4});
  mission.robot_progress(blocked, now);
  ASSERT_TRUE(mission.step(now, kNeverOver));
  const TimedPath& path = mission.plan()->members[0].path;
  for (double time_s = 0.0; time_s < path.duration_s(); time_s += 0.2) {
    EXPECT_GT((pose_at(path, time_s).position() - ahead).norm(), 0.5);
  }
}

TEST_F(SearchMissionTest, BothAreCreditedWithWhatTheySee) {
  run();
  ASSERT_TRUE(plan());
  carry_out(seconds{30});
  const auto explored = mission.explored();

  EXPECT_GT(explored.by_agent[0], 0.05);
  EXPECT_GT(explored.by_agent[1], 0.15);
  EXPECT_NEAR(explored.by_agent[0] + explored.by_agent[1], explored.all, 1e-9);
  EXPECT_LT(mission.belief()->probability_left(), 0.75);
}

TEST_F(SearchMissionTest, ThatTheSearchWentDifferentlyIsNoticed) {
  run();
  ASSERT_TRUE(plan());
  pass(seconds{25});  // nobody moves
  ASSERT_TRUE(mission.step(now, kNeverOver));
  EXPECT_EQ(mission.plan()->reason, "less was seen than planned");
}

TEST_F(SearchMissionTest, APersonWhoIsAFewSecondsLateIsStillOnThePlan) {
  run();
  ASSERT_TRUE(plan());
  person_late_s = 8.0;
  for (int i = 0; i < 30; ++i) {
    carry_out(seconds{1});
    EXPECT_FALSE(mission.step(now, kNeverOver)) << mission.plan()->reason;
  }
}

TEST_F(SearchMissionTest, APersonWhoStaysElsewhereIsPlannedForAnew) {
  run();
  ASSERT_TRUE(plan());
  const Pose2 corner = person.x < 8.0 ? Pose2{15.5, 9.5, 0.0} : Pose2{1.0, 1.0, 0.0};
  bool planned = false;
  for (int i = 0; i < 300 && !planned; ++i) {
    now += milliseconds{200};
    robot = pose_at(mission.plan()->members[0].path, to_seconds(now - mission.plan()->start));
    person = corner;
    tell_poses();
    planned = mission.step(now, kNeverOver);
  }
  EXPECT_TRUE(planned);
}

TEST_F(SearchMissionTest, ARobotShutInByWhatWasBlockedTriesAgain) {
  run();
  ASSERT_TRUE(plan());
  carry_out(seconds{4});
  auto blocked = progress();
  blocked.blocked = true;
  blocked.blocked_at_in_map = robot.position() + Vector2d{0.1, 0.0};
  mission.robot_progress(blocked, now);
  pass(seconds{4});
  ASSERT_TRUE(mission.step(now, kNeverOver));
  EXPECT_GT(mission.plan()->members[0].path.duration_s(), 5.0);
}

TEST_F(SearchMissionTest, PlansForTheRobotAloneAfterAWhileAndForBothOnceThePersonIsKnown) {
  SearchMission alone(config(), "robot", "person");
  alone.set_map(empty_room(16, 10));
  alone.robot_at(now, robot);
  alone.run_session("s1", now);
  EXPECT_FALSE(alone.step(now, kNeverOver));
  now += seconds{11};
  alone.robot_at(now, robot);
  ASSERT_TRUE(alone.step(now, kNeverOver));
  EXPECT_EQ(alone.plan()->members.size(), 1U);
  now += seconds{1};
  alone.person_at(now, person, 0.0);
  ASSERT_TRUE(alone.step(now, kNeverOver));
  EXPECT_EQ(alone.plan()->members.size(), 2U);
}

TEST_F(SearchMissionTest, ADetectionEndsTheSearch) {
  run();
  ASSERT_TRUE(plan());
  carry_out(seconds{5});
  mission.found();
  EXPECT_EQ(mission.activity(), MissionActivity::Finished);
  EXPECT_EQ(mission.standing(now), PlanStanding::Superseded);
  EXPECT_FALSE(mission.step(now, kNeverOver));
  EXPECT_TRUE(mission.request({PersonRequest::Kind::Replan, {}}, now));  // refused
}

TEST_F(SearchMissionTest, AnotherSessionIsANewSearch) {
  run();
  ASSERT_TRUE(plan());
  carry_out(seconds{10});
  mission.found();
  mission.run_session("s2", now);
  EXPECT_NEAR(mission.belief()->probability_left(), 1.0, 1e-9);
  EXPECT_TRUE(plan());
}

TEST_F(SearchMissionTest, ASearchDoesNotDependOnTheOneBefore) {
  const Pose2 robot_start = robot;
  const Pose2 person_start = person;
  run();
  ASSERT_TRUE(plan());
  const auto first = paths();
  carry_out(seconds{20});
  robot = robot_start;
  person = person_start;
  pass(std::chrono::hours{1});
  mission.run_session("s2", now);
  ASSERT_TRUE(plan());
  ASSERT_EQ(paths().size(), first.size());
  for (std::size_t m = 0; m < first.size(); ++m) {
    ASSERT_EQ(paths()[m].points.size(), first[m].points.size());
    for (std::size_t i = 0; i < first[m].points.size(); ++i) {
      EXPECT_EQ(paths()[m].points[i].point_in_map, first[m].points[i].point_in_map);
    }
  }
}

TEST_F(SearchMissionTest, WhenTheTimeIsUpTheBestPlanSoFarIsProposed) {
  EXPECT_FALSE(mission.conclude(now));  // nothing is being computed
  run();
  EXPECT_FALSE(mission.step(now, [] { return true; }));
  EXPECT_TRUE(mission.conclude(now));
  EXPECT_EQ(mission.standing(now), PlanStanding::Proposed);
  EXPECT_EQ(mission.activity(), MissionActivity::Idle);
}

TEST_F(SearchMissionTest, NoFloorToSearchIsAFailureWithAReason) {
  SearchMission walled(config(), "robot", "person");
  walled.set_map(room({"###", "###"}));
  walled.robot_at(now, robot);
  walled.run_session("s1", now);
  EXPECT_FALSE(walled.step(now, kNeverOver));
  EXPECT_EQ(walled.activity(), MissionActivity::Failed);
  EXPECT_FALSE(walled.failure().empty());
}

}  // namespace
}  // namespace tandem
