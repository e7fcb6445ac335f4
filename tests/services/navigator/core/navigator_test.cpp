#include "services/navigator/core/navigator.hpp"

#include <gtest/gtest.h>

#include "tests/services/navigator/core/driving.hpp"

namespace tandem::navigator {
namespace {

const NavigatorConfig kConfig;
const std::vector<Wall> kHall = box(-10.0, -10.0, 20.0, 20.0);

TEST(Navigator, FollowsAPathWithCornersWithin15Centimetres) {
  Drive drive{kConfig, kHall, {0.0, 0.0, 0.0}};
  const std::vector<Eigen::Vector2d> points = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {0.0, 4.0}, {3.0, 8.0}};
  drive.accept(points);
  const Path path{points};
  double worst = 0.0;
  const bool arrived = drive.drive_until(120.0, [&](const Decision& decision) {
    worst = std::max(worst, path.nearest(drive.pose().position(), 0.0, path.length_m()).distance_m);
    return decision.execution.finished;
  });
  EXPECT_TRUE(arrived);
  EXPECT_LT(worst, 0.15);
  EXPECT_LT((drive.pose().position() - Eigen::Vector2d(3.0, 8.0)).norm(), 0.25);
}

TEST(Navigator, TurnsInPlaceTowardsAPathThatBeginsBehindIt) {
  Drive drive{kConfig, kHall, {0.0, 0.0, std::numbers::pi}};
  drive.accept({{0.0, 0.0}, {3.0, 0.0}});
  EXPECT_TRUE(drive.drive_to_goal(25.0));
  EXPECT_NEAR(drive.pose().y, 0.0, 0.15);
}

TEST(Navigator, RidesThroughACorridorAndARightAngle90CentimetresWide) {
  // An L of 0.9 m: the path runs in its middle, 0.45 m from the walls, where there is no room to turn in place.
  std::vector<Wall> walls = {{{-1.0, -0.45}, {5.45, -0.45}},
                             {{5.45, -0.45}, {5.45, 6.0}},
                             {{-1.0, 0.45}, {4.55, 0.45}},
                             {{4.55, 0.45}, {4.55, 6.0}}};
  Drive drive{kConfig, walls, {0.0, 0.0, 0.0}};
  drive.accept({{0.0, 0.0}, {5.0, 0.0}, {5.0, 5.0}});
  EXPECT_TRUE(drive.drive_to_goal(90.0)) << drive.pose().x << " " << drive.pose().y << " " << drive.pose().heading;
  EXPECT_GT(drive.least_clearance_m(), 0.02);
}

TEST(Navigator, FindsRoomToTurnWhereAWallIsTooNearForTurningInPlace) {
  Drive drive{kConfig, {{{-5.0, -0.42}, {5.0, -0.42}}}, {0.0, 0.0, 0.0}};  // a wall at its right hand
  drive.accept({{0.0, 0.0}, {-3.0, 0.0}});                                 // and the path leads back
  EXPECT_TRUE(drive.drive_to_goal(60.0));
  EXPECT_GT(drive.least_clearance_m(), 0.05);
}

TEST(Navigator, GoesAroundASmallObstacleOnItsPath) {
  std::vector<Wall> walls = kHall;
  for (const auto& wall : box(2.9, -0.1, 3.1, 0.1)) walls.push_back(wall);
  Drive drive{kConfig, walls, {0.0, 0.0, 0.0}};
  drive.accept({{0.0, 0.0}, {6.0, 0.0}});
  EXPECT_TRUE(drive.drive_to_goal(60.0));
  EXPECT_GT(drive.least_clearance_m(), 0.04);
}

TEST(Navigator, X5StandsWhileTwoPlannersPlanForIt) {
  Drive drive{kConfig, kHall, {0.0, 0.0, 0.0}};
  drive.accept({{0.0, 0.0}, {6.0, 0.0}});
  EXPECT_TRUE(drive.drive_until(5.0, [&](const Decision& decision) { return decision.execution.moving; }));
  drive.second_planner = true;
  EXPECT_TRUE(drive.drive_until(3.0, [&](const Decision& decision) {
    return decision.execution.reason ==
           "X5: two planners plan for this robot: planner@laptop and planner@elsewhere; end one";
  }));
  EXPECT_TRUE(drive.drive_until(3.0, [&](const Decision&) { return drive.velocity() == Twist2{}; }));
  EXPECT_FALSE(drive.drive_until(10.0, [&](const Decision& decision) { return decision.velocity != Twist2{}; }));

  drive.second_planner = false;
  EXPECT_TRUE(drive.drive_to_goal(60.0));
}

TEST(Navigator, ReportsWhereItIsBlockedAndGoesOnWhenTheWayIsFree) {
  std::vector<Wall> walls = {{{3.0, -8.0}, {3.0, 8.0}}};  // too wide to get around
  Drive drive{kConfig, walls, {0.0, 0.0, 0.0}};
  drive.accept({{0.0, 0.0}, {6.0, 0.0}});
  Execution execution;
  EXPECT_TRUE(drive.drive_until(30.0, [&](const Decision& decision) {
    execution = decision.execution;
    return execution.blocked;
  }));
  EXPECT_NEAR(execution.blocked_at_in_map.x(), 3.0, 0.1);
  EXPECT_LT(std::abs(execution.blocked_at_in_map.y()), 0.5);
  EXPECT_EQ(execution.reason, "something is in the way");
  EXPECT_GT(drive.least_clearance_m(), 0.15);

  drive.walls().clear();
  EXPECT_TRUE(drive.drive_to_goal(30.0));
}

TEST(Navigator, ReachesAGoal45CentimetresBeforeAWall) {
  Drive drive{kConfig, {{{3.45, -8.0}, {3.45, 8.0}}}, {0.0, 0.0, 0.0}};
  drive.accept({{0.0, 0.0}, {3.0, 0.0}});
  EXPECT_TRUE(drive.drive_to_goal(30.0));
  EXPECT_LT((drive.pose().position() - Eigen::Vector2d(3.0, 0.0)).norm(), 0.25);
}

TEST(Navigator, IsContentBesideAGoalThatSomethingStandsOn) {
  std::vector<Wall> walls = {{{3.0, -8.0}, {3.0, 8.0}}};
  Drive drive{kConfig, walls, {0.0, 0.0, 0.0}};
  drive.accept({{0.0, 0.0}, {2.95, 0.0}});
  EXPECT_TRUE(drive.drive_to_goal(30.0));
  EXPECT_FALSE(drive.step().execution.blocked);
}

TEST(Navigator, StopsWhenThePlanIsNotRefreshed) {
  Drive drive{kConfig, kHall, {0.0, 0.0, 0.0}};
  drive.accept({{0.0, 0.0}, {10.0, 0.0}});
  ASSERT_FALSE(drive.drive_until(6.0, [](const Decision&) { return false; }));
  EXPECT_NEAR(drive.velocity().forward_mps, 0.5, 0.01);
  drive.refreshing = false;
  const Time silent = drive.now();
  ASSERT_TRUE(drive.drive_until(5.0, [](const Decision& decision) { return decision.velocity == Twist2{}; }));
  EXPECT_LE(to_seconds(drive.now() - silent), 2.1);
  EXPECT_EQ(drive.step().execution.reason, "the planner no longer repeats its plan");
}

/// Drives 3 m of a path of 10 m and then loses the link; the planner is no longer heard either.
void lose_the_link(Drive& drive) {
  drive.accept({{0.0, 0.0}, {8.0, 0.0}});
  ASSERT_TRUE(drive.drive_until(20.0, [&](const Decision&) { return drive.pose().x > 3.0; }));
  drive.link_lost = true;
  drive.refreshing = false;
}

TEST(Navigator, FinishesItsLegWithoutALinkWhereTheSiteSaysSo) {
  Drive drive{kConfig, kHall, {0.0, 0.0, 0.0}, LinkLoss::FinishLeg};
  lose_the_link(drive);
  EXPECT_TRUE(drive.drive_to_goal(30.0));
  EXPECT_NEAR(drive.pose().x, 8.0, 0.25);
}

TEST(Navigator, BeginsNoPlanWithoutALink) {
  Drive drive{kConfig, kHall, {0.0, 0.0, 0.0}, LinkLoss::FinishLeg};
  drive.link_lost = true;
  drive.accept({{0.0, 0.0}, {8.0, 0.0}});
  drive.refreshing = false;
  EXPECT_FALSE(drive.drive_to_goal(10.0));
  EXPECT_LT(drive.pose().x, 1.5) << "two seconds, until the plan is dead";
}

TEST(Navigator, RetreatsTheWayItCameAndTakesUpItsPlanOnceTheLinkIsThereAgain) {
  Drive drive{kConfig, kHall, {0.0, 0.0, 0.0}, LinkLoss::Retreat};
  lose_the_link(drive);
  EXPECT_TRUE(drive.drive_to_goal(40.0));
  EXPECT_NEAR(drive.pose().x, 0.0, 0.25);
  drive.link_lost = false;
  drive.refreshing = true;
  EXPECT_TRUE(drive.drive_until(
      60.0, [&](const Decision& decision) { return decision.execution.finished && drive.pose().x > 7.0; }));
}

TEST(Navigator, StopsWithoutPoseOrScanAndWhenThePoseIsLost) {
  for (const std::string missing : {"no pose", "no scan", "the pose is lost"}) {
    Drive drive{kConfig, kHall, {0.0, 0.0, 0.0}};
    drive.accept({{0.0, 0.0}, {10.0, 0.0}});
    ASSERT_FALSE(drive.drive_until(3.0, [](const Decision&) { return false; }));
    if (missing == "no pose") drive.localized = false;
    if (missing == "no scan") drive.scanning = false;
    if (missing == "the pose is lost") drive.quality = PoseQuality::Lost;
    const Decision decision = drive.step();
    EXPECT_EQ(decision.velocity, Twist2{});
    EXPECT_EQ(decision.execution.reason, missing);
    EXPECT_FALSE(decision.execution.moving);
  }
}

TEST(Navigator, APoseOlderThanHalfASecondIsNone) {
  Navigator navigator{kConfig};
  const Time now = from_stamp_ns(0) + from_seconds(1000.0);
  for (std::uint64_t i = 1; i <= 2; ++i) {
    navigator.receive_plan(
        {"p", "S1", "planner", i, PlanState::Accepted, now + from_seconds(60.0), {{0.0, 0.0}, {5.0, 0.0}}}, now);
  }
  Situation situation;
  situation.now = now;
  situation.running_session = "S1";
  situation.obstacles = ScanHits{{}, now, now};
  situation.pose = LocatedPose{{}, PoseQuality::Good, now, now - from_seconds(0.4)};
  EXPECT_GT(navigator.decide(situation).velocity.forward_mps, 0.0);
  situation.pose->received = now - from_seconds(0.6);
  EXPECT_EQ(navigator.decide(situation).velocity, Twist2{});
  situation.pose->received = now;
  situation.running_session.reset();
  EXPECT_EQ(navigator.decide(situation).execution.reason, "no session is running");
}

TEST(Navigator, AStopPressedByAPersonIsNotABlockedPath) {
  Drive drive{kConfig, kHall, {0.0, 0.0, 0.0}};
  drive.accept({{0.0, 0.0}, {10.0, 0.0}});
  ASSERT_FALSE(drive.drive_until(3.0, [](const Decision&) { return false; }));
  drive.base = {"stop requested", false};
  ASSERT_FALSE(drive.drive_until(20.0, [](const Decision& decision) { return decision.execution.blocked; }));
  EXPECT_EQ(drive.step().execution.reason, "the base is stopped: stop requested");
  EXPECT_FALSE(drive.step().execution.moving);
  drive.base = {};
  EXPECT_TRUE(drive.drive_to_goal(40.0));
}

TEST(Navigator, TakesUpTheNextPlanWhereItIs) {
  Drive drive{kConfig, kHall, {0.0, 0.0, 0.0}};
  drive.accept({{0.0, 0.0}, {10.0, 0.0}});
  ASSERT_FALSE(drive.drive_until(6.0, [](const Decision&) { return false; }));
  drive.accept({{0.5, 0.0}, {5.0, 0.0}, {5.0, 5.0}}, "plan2");
  const Decision decision = drive.step();
  EXPECT_EQ(decision.execution.plan_id, "plan2");
  EXPECT_GT(decision.execution.progress, 0.1);  // 2 m of its 9.5 m are behind already
  EXPECT_TRUE(drive.drive_to_goal(40.0));
}

TEST(Navigator, NeverExceedsItsLimitsOnRandomPathsInARoomWithObstacles) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Rng rng{seed};
    std::vector<Wall> walls = box(-0.5, -0.5, 8.5, 8.5);
    for (int i = 0; i < 5; ++i) {
      const double x = rng.uniform(1.5, 8.0);
      const double y = rng.uniform(1.5, 8.0);
      for (const auto& wall : box(x - 0.15, y - 0.15, x + 0.15, y + 0.15)) walls.push_back(wall);
    }
    Drive drive{kConfig, walls, {0.3, 0.3, rng.uniform(-3.0, 3.0)}};
    std::vector<Eigen::Vector2d> points = {{0.3, 0.3}};
    for (int i = 0; i < 4; ++i) points.emplace_back(rng.uniform(0.2, 7.8), rng.uniform(0.2, 7.8));
    drive.accept(points);
    Twist2 last;
    drive.drive_until(40.0, [&](const Decision& decision) {
      const Twist2& velocity = decision.velocity;
      EXPECT_GE(velocity.forward_mps, 0.0) << "seed " << seed;
      EXPECT_LE(velocity.forward_mps, kConfig.max_speed_mps + 1e-9) << "seed " << seed;
      EXPECT_LE(std::abs(velocity.turn_rate_radps), kConfig.max_turn_rate_radps + 1e-9) << "seed " << seed;
      EXPECT_LE(velocity.forward_mps, last.forward_mps + kConfig.acceleration_mps2 * kConfig.period_s + 1e-9);
      EXPECT_EQ(velocity.left_mps, 0.0);
      last = velocity;
      return decision.execution.finished;
    });
    EXPECT_GT(drive.least_clearance_m(), 0.0) << "seed " << seed;
  }
}

}  // namespace
}  // namespace tandem::navigator
