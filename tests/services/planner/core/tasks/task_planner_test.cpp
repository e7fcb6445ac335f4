#include "services/planner/core/tasks/task_planner.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/tasks.hpp"

namespace tandem {
namespace {

TEST(TaskPlanner, StopsWhenNothingBetterCanExist) {
  TaskPlanner planner{task_of({task_agent("a", 0.0, 0.0)}, {spot("s", 3.0, 0.0, 2.0)}, {}, 10.0), Rng{1}};
  planner.run(1'000'000);
  EXPECT_TRUE(planner.is_finished());
  EXPECT_LT(planner.rollouts(), 100);
  EXPECT_TRUE(planner.best()->is_proven());
}

TEST(TaskPlanner, StopsWhenItIsTold) {
  std::vector<RewardSource> sources;
  for (int i = 0; i < 12; ++i)
    sources.push_back(spot("s" + std::to_string(i), i % 4 * 3.0, i / 4 * 2.5, 1.0 + 0.1 * i));
  TaskPlanner planner{task_of({task_agent("a", 0.0, 0.0), task_agent("b", 5.0, 5.0)}, sources, {}, 9.0), Rng{1}};
  int asked = 0;
  planner.run(1000, [&] { return ++asked == 7; });
  EXPECT_EQ(planner.rollouts(), 7);
}

TEST(TaskPlanner, OfEqualPlansTakesTheOneThatEndsFirst) {
  // Both orders get all; left first is 1 + 4 m, right first 3 + 4 m.
  const TaskProblem problem =
      task_of({task_agent("a", 0.0, 0.0)}, {spot("r", 3.0, 0.0, 1.0), spot("l", -1.0, 0.0, 1.0)}, {}, 30.0);
  const auto plan = plan_task(problem, 500, Rng{1});
  ASSERT_TRUE(plan);
  EXPECT_EQ(visits_of(problem, *plan, 0), "l r");
}

TEST(TaskPlanner, OfEqualPlansThatEndTogetherTakesTheOneInExecution) {
  TaskProblem problem =
      task_of({task_agent("a", 0.0, 0.0)}, {spot("l", -2.0, 0.0, 1.0), spot("r", 2.0, 0.0, 1.0)}, {}, 30.0);
  for (const std::string first : {"l", "r"}) {
    problem.in_execution = {{first}};
    const auto plan = plan_task(problem, 500, Rng{1});
    ASSERT_TRUE(plan);
    EXPECT_EQ(visits_of(problem, *plan, 0).substr(0, 1), first);
  }
}

TEST(TaskPlanner, TheFirstPlanIsNoWorseThanThePlanInExecution) {
  // The greedy ones run after the big prize on the left; the plan in execution collects four on the right.
  TaskProblem problem = task_of({task_agent("a", 0.0, 0.0)},
                                {spot("big", -1.0, 0.0, 3.0), spot("r1", 7.0, 0.0, 2.0), spot("r2", 8.0, 0.0, 2.0),
                                 spot("r3", 9.0, 0.0, 2.0), spot("r4", 10.0, 0.0, 2.0)},
                                {}, 10.5);
  const double greedy = plan_task(problem, 0, Rng{1})->value;
  EXPECT_LE(greedy, 8.0);
  problem.in_execution = {{"r1", "r2", "r3", "r4"}};
  EXPECT_NEAR(plan_task(problem, 0, Rng{1})->value, 8.0, 1e-6);
}

TEST(TaskPlanner, LatencyOfAPersonMakesTheMateGo) {
  // Equally far from both; the person starts 5 s later.
  TaskProblem problem =
      task_of({task_agent("person", -5.0, 0.0), task_agent("robot", 5.0, 0.0)}, {spot("s", 0.0, 0.0, 1.0)}, {}, 30.0);
  problem.agents[0].committed.points = {{0.0, {-5.0, 0.0}}, {5.0, {-5.0, 0.0}}};
  const auto plan = plan_task(problem, 500, Rng{1});
  ASSERT_TRUE(plan);
  EXPECT_EQ(visits_of(problem, *plan, 0), "");
  EXPECT_EQ(visits_of(problem, *plan, 1), "s");
}

TEST(TaskPlanner, HoldsBackTheMateWhoWouldSilenceAReward) {
  const TaskProblem problem =
      task_of({task_agent("a", 0.0, 0.0), task_agent("b", 0.0, 5.0)},
              {spot("i", 4.0, 0.0, 5.0, {"a"}), spot("j", 1.0, 5.0, 5.0, {"b"})}, {soft("i", "j")}, 30.0);
  const auto plan = plan_task(problem, 1000, Rng{1});
  ASSERT_TRUE(plan);
  EXPECT_NEAR(plan->value, 10.0, 1e-9);
  EXPECT_GE(plan->agents[1].visits[0].leave_s, 4.0);
}

TEST(TaskPlanner, HasNoPlanIfAllAreRejected) {
  TaskProblem problem = task_of({task_agent("a", 0.0, 0.0)}, {}, {}, 5.0);
  problem.rejected = {{TimedPath{{{0.0, {0.0, 0.0}}}}}};
  EXPECT_FALSE(plan_task(problem, 100, Rng{1}));
}

}  // namespace
}  // namespace tandem
