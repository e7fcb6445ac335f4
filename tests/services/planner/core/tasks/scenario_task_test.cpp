#include "services/planner/core/tasks/scenario_task.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

TEST(ScenarioTask, TheTeamOfTheScenarioIsTheTeamOfTheTask) {
  PlanningScenario scenario;
  scenario.place = DrawnRoom{};
  scenario.horizon_s = 40.0;
  scenario.altitudes_m = {0.0, 3.0};
  ScenarioAgent person;
  person.searcher.id = "person";
  person.start = {1.0, 2.0, 0.5};
  person.latency_s = 4.0;
  person.goal_in_map = Eigen::Vector2d{7.0, 7.0};
  ScenarioAgent drone;
  drone.searcher.id = "drone";
  drone.altitude_m = 3.0;
  drone.searcher.layer = 1;
  drone.searcher.endurance_s = 90.0;
  scenario.agents = {person, drone};
  scenario.world.agents = {"person", "drone"};

  const TaskProblem problem = task_problem_of(scenario);
  EXPECT_FALSE(problem_of(problem));
  EXPECT_EQ(problem.layers.size(), 2U);
  EXPECT_EQ(problem.horizon_s, 40.0);
  EXPECT_EQ(problem.agents[0].start, (Pose2{1.0, 2.0, 0.5}));
  EXPECT_EQ(problem.agents[0].committed.duration_s(), 4.0);  // it stands and reads
  EXPECT_EQ(problem.agents[0].committed.points.back().point_in_map, (Eigen::Vector2d{1.0, 2.0}));
  EXPECT_TRUE(problem.agents[0].goal_in_map);
  EXPECT_TRUE(problem.agents[1].committed.points.empty());
  EXPECT_EQ(problem.agents[1].searcher.layer, 1);
  EXPECT_EQ(problem.agents[1].searcher.endurance_s, 90.0);
}

}  // namespace
}  // namespace tandem
