#include "services/navigator/navigator_messages.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace tandem::navigator {
namespace {

msg::TimedPoint point(double x_m, double y_m) {
  msg::TimedPoint timed;
  timed.x_m(x_m);
  timed.y_m(y_m);
  return timed;
}

msg::TeamPlan two_paths() {
  msg::TeamPlan plan;
  plan.id("p1");
  plan.session("S1");
  plan.planner("laptop1/4711");
  plan.sequence_number(3);
  plan.valid_until_ns(5'000'000'000);
  plan.state(msg::PLAN_ACCEPTED);
  msg::PlannedPath person;
  person.agent("person1");
  person.points({point(9.0, 9.0)});
  msg::PlannedPath robot;
  robot.agent("robot1");
  robot.points({point(1.0, 2.0), point(3.0, 4.0)});
  plan.paths({person, robot});
  return plan;
}

TEST(NavigatorMessages, TakeTheRobotsOwnPathOutOfATeamPlan) {
  const PlanNews news = plan_news(two_paths(), "robot1");
  EXPECT_EQ(news.id, "p1");
  EXPECT_EQ(news.session, "S1");
  EXPECT_EQ(news.planner, "laptop1/4711");
  EXPECT_EQ(news.sequence_number, 3u);
  EXPECT_EQ(news.state, PlanState::Accepted);
  EXPECT_EQ(to_stamp_ns(news.valid_until), 5'000'000'000);
  ASSERT_EQ(news.points_in_map.size(), 2u);
  EXPECT_EQ(news.points_in_map[1], Eigen::Vector2d(3.0, 4.0));
  EXPECT_TRUE(plan_news(two_paths(), "robot2").points_in_map.empty());
}

TEST(NavigatorMessages, APathThatIsNotFiniteIsNone) {
  msg::TeamPlan plan = two_paths();
  plan.paths()[1].points()[1].x_m(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(plan_news(plan, "robot1").points_in_map.empty());
}

TEST(NavigatorMessages, AnUnknownPlanStateMovesNothing) {
  msg::TeamPlan plan = two_paths();
  plan.state(static_cast<msg::PlanState>(77));
  EXPECT_EQ(plan_news(plan, "robot1").state, PlanState::Rejected);
}

TEST(NavigatorMessages, PlaceTheHitsOfAScanInTheBaseFrame) {
  msg::LaserScan scan;
  scan.stamp_ns(7);
  scan.base_from_laser().x(0.16);
  scan.angle_min_rad(0.0);
  scan.angle_increment_rad(std::numbers::pi / 2.0);
  scan.range_min_m(0.1);
  scan.range_max_m(30.0);
  scan.ranges_m({2.0F, std::numeric_limits<float>::quiet_NaN(), 30.0F, 1.0F});  // ahead, none, none, right

  const ScanHits hits = scan_hits(scan);

  ASSERT_EQ(hits.points_in_base.size(), 2u);
  EXPECT_NEAR((hits.points_in_base[0] - Eigen::Vector2d(2.16, 0.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((hits.points_in_base[1] - Eigen::Vector2d(0.16, -1.0)).norm(), 0.0, 1e-9);
  EXPECT_EQ(to_stamp_ns(hits.stamp), 7);
}

TEST(NavigatorMessages, APoseThatIsNotFiniteIsLost) {
  msg::RobotPose pose;
  pose.status(msg::LOCALIZATION_OK);
  pose.map_from_base().x(1.5);
  EXPECT_EQ(located_pose(pose).quality, PoseQuality::Good);
  EXPECT_EQ(located_pose(pose).map_from_base.x, 1.5);
  pose.map_from_base().heading(std::numeric_limits<double>::infinity());
  EXPECT_EQ(located_pose(pose).quality, PoseQuality::Lost);
}

TEST(NavigatorMessages, TellAnObstacleFromOtherReasonsOfTheBase) {
  msg::BaseStatus status;
  EXPECT_TRUE(base_report(status).stopped_by.empty());
  status.stop_reasons({msg::STOP_OBSTACLE});
  EXPECT_TRUE(base_report(status).by_obstacle);
  status.stop_reasons({msg::STOP_REQUESTED, msg::STOP_OBSTACLE});
  EXPECT_FALSE(base_report(status).by_obstacle);
  EXPECT_EQ(base_report(status).stopped_by, "somebody pressed STOP");
}

TEST(NavigatorMessages, OnlyARunningSessionCounts) {
  msg::SessionState session;
  session.code("S1");
  session.phase(msg::SESSION_PREPARING);
  EXPECT_FALSE(running_session(session));
  session.phase(msg::SESSION_RUNNING);
  EXPECT_EQ(running_session(session), "S1");
  session.phase(msg::SESSION_ENDED);
  EXPECT_FALSE(running_session(session));
}

TEST(NavigatorMessages, SayWhoCommandsAndHowThePlanGoes) {
  const auto command = velocity_command({0.5, 0.0, -0.25}, "robot1", from_stamp_ns(9), 4);
  EXPECT_EQ(command.commander(), "navigator");
  EXPECT_EQ(command.forward_mps(), 0.5);
  EXPECT_EQ(command.turn_rate_radps(), -0.25);
  EXPECT_EQ(command.sequence_number(), 4u);
  EXPECT_EQ(command.stamp_ns(), 9);

  Execution execution;
  execution.plan_id = "p1";
  execution.progress = 0.5;
  execution.blocked = true;
  execution.blocked_at_in_map = {1.0, 2.0};
  const auto message = plan_execution(execution, "robot1", from_stamp_ns(9));
  EXPECT_EQ(message.plan_id(), "p1");
  EXPECT_EQ(message.progress(), 0.5);
  EXPECT_TRUE(message.blocked());
  EXPECT_EQ(message.blocked_at_in_map().y(), 2.0);
}

}  // namespace
}  // namespace tandem::navigator
