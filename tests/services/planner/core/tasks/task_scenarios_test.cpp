// The tasks under config/scenarios/tasks, each with the plan that is best by hand.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "services/planner/core/tasks/scenario_task.hpp"
#include "tests/services/planner/support/tasks.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

const std::filesystem::path kTasks = std::filesystem::path{TANDEM_SOURCE_DIR} / "config" / "scenarios" / "tasks";

struct Planned {
  TaskProblem problem;
  TaskPlan plan;

  [[nodiscard]] std::string visits(std::size_t agent) const { return visits_of(problem, plan, agent); }
};

Planned planned(const std::string& name, std::int64_t rollouts = 2000) {
  const PlanningScenario scenario = load_planning_scenario(kTasks / (name + ".json"));
  Planned result{task_problem_of(scenario), {}};
  EXPECT_FALSE(problem_of(result.problem)) << name;
  auto plan = plan_task(result.problem, rollouts, Rng{1});
  EXPECT_TRUE(plan) << name;
  if (plan) result.plan = std::move(*plan);
  return result;
}

// Sources have a radius of 0.1 m and give all they have within 0.1 s: times and ways are exact to a few of those.
constexpr double kTime_s = 0.25;

TEST(TaskScenarios, ConsumedPoolsAreCollectedOneAfterTheOther) {
  // 2 m to each of three blue ones (1 each), 2 m to the green one (10): 8 s.
  const Planned it = planned("pools_consumed");
  EXPECT_EQ(it.visits(0), "blue1 blue2 blue3 green");
  EXPECT_NEAR(it.plan.value, 13.0, 1e-6);
  EXPECT_NEAR(it.plan.makespan_s, 8.0, kTime_s);
}

TEST(TaskScenarios, APermanentPoolIsWorthStayingAtUntilItIsJustTimeForTheLast) {
  // blue1 on the way: 1 m at 1 m/s, 0.5/s: 0.5. blue2 from x = 4.5 (t = 3.5) on; it is left from x = 5 at t = 15.9, 4 m
  // and 0.1 s of drawing before the end, and x = 5.5 is passed at 16.4: 12.9. blue3 on the way: 0.5. Green: 10.
  const Planned it = planned("pools_permanent");
  EXPECT_EQ(it.visits(0), "blue2 green");
  EXPECT_NEAR(it.plan.value, 23.9, 0.01);
  EXPECT_NEAR(it.plan.agents[0].visits[0].leave_s, 15.9, 0.01);
  EXPECT_NEAR(it.plan.makespan_s, 20.0, kTime_s);
}

TEST(TaskScenarios, ThePlaceBesideAPersonIsWorthMoreThanTheDoor) {
  // Beside the person from the start: 0.5/s for 10 s = 5. The door pays 2, and after it the robot catches up only when
  // the person stands still, at 8.6 s: 2 + 0.7 and a little.
  const Planned it = planned("task_against_interaction");
  EXPECT_EQ(it.visits(1).substr(0, 6), "beside");
  EXPECT_EQ(it.visits(1).find("door"), std::string::npos);
  EXPECT_NEAR(it.plan.value, 5.0, 0.05);
  EXPECT_NEAR(it.plan.agents[0].end_s, 8.0, kTime_s);
}

TEST(TaskScenarios, TheRobotWalksAtThePersonsSide) {
  // 1/s for all 10 s; 1 m to the right of the person all the time.
  const Planned it = planned("side_by_side");
  EXPECT_EQ(it.visits(1).substr(0, 6), "beside");
  EXPECT_NEAR(it.plan.value, 10.0, 0.05);
  for (const double time_s : {1.0, 4.0, 7.0, 9.0}) {
    const Vector2d person = pose_at(it.plan.agents[0].path, time_s).position();
    const Vector2d robot = pose_at(it.plan.agents[1].path, time_s).position();
    EXPECT_NEAR((robot - person - Vector2d{0.0, -1.0}).norm(), 0.0, 0.1) << time_s;
  }
}

TEST(TaskScenarios, TheProductIsTakenBeforePayingAtOneCashierOfThree) {
  // (1,1) to (3,5): 4.47 m; to the middle cashier (8,4): 5.10 m; to the exit (11,4): 3 m. 2 + 5 + 10, one cashier only.
  const Planned it = planned("supermarket");
  EXPECT_EQ(it.visits(0), "product cashier2 exit");
  EXPECT_NEAR(it.plan.value, 17.0, 1e-6);
  EXPECT_NEAR(it.plan.makespan_s, std::sqrt(20.0) + std::sqrt(26.0) + 3.0, kTime_s);
}

TEST(TaskScenarios, SmallRewardsBendThePath) {
  // An arc of 2 sqrt(8) + 2 sqrt(5) = 10.13 m at 0.1 a second: 3 + 10 - 1.01. blue4 would cost 7.6 m more for 0.2.
  const Planned it = planned("path_shaping");
  EXPECT_EQ(it.visits(0), "blue1 blue2 blue3 green");
  const double way_m = 2.0 * std::sqrt(8.0) + 2.0 * std::sqrt(5.0);
  EXPECT_NEAR(it.plan.value, 13.0 - 0.1 * way_m, 0.02);
  EXPECT_NEAR(it.plan.makespan_s, way_m, kTime_s);
}

TEST(TaskScenarios, TheRoadIsCrossedAtTheCrossingAroundTheCar) {
  // The car lies half-way to the crossing, radius 0.5: two tangents of sqrt(2) and an arc of 0.34 instead of 3 m, then
  // 3 m. The road costs 1/3 a second for its 1 m. 2 + 10 - 1/3.
  const Planned it = planned("crossroad");
  EXPECT_EQ(it.visits(0), "crossing flag");
  EXPECT_NEAR(it.plan.value, 12.0 - 1.0 / 3.0, 0.05);
  EXPECT_GE(it.plan.makespan_s, 6.1);
  EXPECT_LE(it.plan.makespan_s, 6.6);
}

TEST(TaskScenarios, TheSpidersAreWalkedAround) {
  // Straight ahead, 8 m, the path would cross 1.6 m of one spider and 1.2 m of the other, at 3 a second.
  const Planned it = planned("spiders");
  EXPECT_EQ(it.visits(0), "flag");
  EXPECT_NEAR(it.plan.value, 10.0, 0.05);
  EXPECT_GE(it.plan.makespan_s, 8.1);
  EXPECT_LE(it.plan.makespan_s, 9.0);
}

TEST(TaskScenarios, ADrawnPathIsFollowed) {
  // (1,1) (3,5) (6,1) (9,5): 4.47 + 5 + 5 m; the other order is 16 m.
  const Planned it = planned("free_space");
  EXPECT_EQ(it.visits(0), "through1 through2 flag");
  EXPECT_NEAR(it.plan.value, 12.0, 1e-6);
  EXPECT_NEAR(it.plan.makespan_s, std::sqrt(20.0) + 10.0, kTime_s);
}

TEST(TaskScenarios, TheMatePutsTheLightOnForTheReader) {
  const Planned it = planned("light_and_panel");
  EXPECT_EQ(it.visits(0), "panel");   // 5 m
  EXPECT_EQ(it.visits(1), "switch");  // 2 m
  EXPECT_NEAR(it.plan.value, 11.0, 1e-6);
  EXPECT_NEAR(it.plan.makespan_s, 5.0, kTime_s);
}

TEST(TaskScenarios, TheReaderDoesBothIfTheMateDoesNotKnow) {
  // (1,1) to (3,6): sqrt(29); to (6,1): sqrt(34).
  const Planned it = planned("light_and_panel_unaware");
  EXPECT_TRUE(it.plan.informs.empty());
  EXPECT_EQ(it.visits(0), "switch panel");
  EXPECT_EQ(it.visits(1), "");
  EXPECT_NEAR(it.plan.value, 11.0, 1e-6);
  EXPECT_NEAR(it.plan.makespan_s, std::sqrt(29.0) + std::sqrt(34.0), kTime_s);
}

TEST(TaskScenarios, TheMateIsToldIfTimeIsShort) {
  const Planned it = planned("light_and_panel_inform");
  ASSERT_EQ(it.plan.informs.size(), 1U);
  EXPECT_EQ(it.plan.informs[0], (Inform{"mate", "switch"}));
  EXPECT_EQ(it.visits(0), "panel");
  EXPECT_EQ(it.visits(1), "switch");
  EXPECT_NEAR(it.plan.value, 10.5, 1e-6);
  EXPECT_NEAR(it.plan.value_untold, 1.0, 1e-6);
}

TEST(TaskScenarios, T10TheDroneFliesOverTheWall) {
  // Drone (3,4) to (3,9): 5 m over the wall. Person (2,4) to (6,1): 5 m.
  const Planned it = planned("person_and_drone");
  EXPECT_EQ(it.visits(0), "near");
  EXPECT_EQ(it.visits(1), "behind");
  EXPECT_NEAR(it.plan.value, 10.0, 1e-6);
  EXPECT_NEAR(it.plan.makespan_s, 5.0, kTime_s);
}

TEST(TaskScenarios, T10WithoutADroneThePersonWalksAroundTheWall) {
  // Around the wall's end near (11.9, 6): sqrt(9.9^2 + 2^2) + sqrt(9.9^2 + 3^2) = 20.4 m.
  const Planned it = planned("person_without_drone");
  EXPECT_EQ(it.visits(0), "behind");
  EXPECT_NEAR(it.plan.value, 5.0, 1e-6);
  EXPECT_NEAR(it.plan.makespan_s, 20.4, 0.4);
}

TEST(TaskScenarios, ThreeSharedGoalsOneForEach) {
  // 6 m each at 0.05 a second: 15 - 0.9. 8 s are too few for two of them (10 m).
  const Planned it = planned("three_agents");
  EXPECT_EQ(it.visits(0), "goal1");
  EXPECT_EQ(it.visits(1), "goal2");
  EXPECT_EQ(it.visits(2), "goal3");
  EXPECT_NEAR(it.plan.value, 14.1, 0.02);
  EXPECT_NEAR(it.plan.makespan_s, 6.0, kTime_s);
}

TEST(TaskScenarios, OneMakesAnEffortForAMateWithoutBattery) {
  // 6 m, and 6 + 4 m: 15 - 0.8. All three would be 14 m, and there are 12 s.
  const Planned it = planned("three_agents_effort");
  EXPECT_EQ(it.visits(0), "goal1");
  EXPECT_EQ(it.visits(1), "goal2 goal3");
  EXPECT_EQ(it.visits(2), "");
  EXPECT_NEAR(it.plan.value, 14.2, 0.02);
  EXPECT_NEAR(it.plan.makespan_s, 10.0, kTime_s);
}

TEST(TaskScenarios, WhoseGoalLiesInAHazardStaysWhereItIs) {
  // 1.4 m of hazard on the way in would cost 14 for 5.
  const Planned it = planned("three_agents_inaccessible");
  EXPECT_EQ(it.visits(0), "goal1");
  EXPECT_EQ(it.visits(1), "goal2");
  EXPECT_EQ(it.visits(2), "");
  EXPECT_NEAR(it.plan.value, 10.0 - 0.6, 0.02);
}

TEST(TaskScenarios, HazardsThatHarmOneAgentOnlyAreLeftToTheOthers) {
  // The middle goal falls to one of the outer two, 4 m more: 15 - 0.05 (6 + 10).
  const Planned it = planned("three_agents_one_affected");
  EXPECT_EQ(it.visits(1), "");
  const bool red_does_both = it.visits(0) == "goal1 goal2" && it.visits(2) == "goal3";
  const bool blue_does_both = it.visits(0) == "goal1" && it.visits(2) == "goal3 goal2";
  EXPECT_TRUE(red_does_both || blue_does_both);
  EXPECT_NEAR(it.plan.value, 14.2, 0.02);
  EXPECT_NEAR(it.plan.makespan_s, 10.0, kTime_s);
}

TEST(TaskScenarios, OneFindsTheOtherCarries) {
  // The person is at the shelf after 3 s and looks for 2 s; the robot, sqrt(37) m away, then takes it at 6.1 s and
  // walks sqrt(113) m.
  const Planned it = planned("search_and_retrieve");
  EXPECT_EQ(it.visits(0), "find");
  EXPECT_EQ(it.visits(1), "pick_up bring");
  EXPECT_NEAR(it.plan.value, 12.0, 1e-6);
  EXPECT_NEAR(it.plan.makespan_s, std::sqrt(37.0) + std::sqrt(113.0), kTime_s);
}

TEST(TaskScenarios, EachOfThemHasAProvenOrNearlyProvenPlan) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kTasks)) {
    ++count;
    const Planned it = planned(entry.path().stem().string());
    EXPECT_LE(it.plan.upper_bound, 1.5 * it.plan.value + 1.0) << entry.path();
  }
  EXPECT_EQ(count, 19);
}

}  // namespace
}  // namespace tandem
