#include "services/planner/core/tasks/task_replay.hpp"

#include <gtest/gtest.h>

#include <tuple>

#include "tests/services/planner/support/tasks.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

// 3 m to a source that is empty 3.5 s after it is entered at 2.5 s.
TaskProblem one_source() {
  return task_of({task_agent("a", 0.0, 0.0)}, {disc_source("s", {3.0, 0.0}, 0.5, 2.0, 7.0)}, {}, 20.0);
}

TEST(TaskReplay, KeepsPathVisitsAndTheFallOfThePool) {
  const TaskProblem problem = one_source();
  const auto plan = plan_task(problem, 100, Rng{1});
  ASSERT_TRUE(plan);
  const TaskAgentPlan& agent = plan->agents[0];
  ASSERT_EQ(agent.visits.size(), 1U);
  EXPECT_EQ(agent.visits[0], (TaskVisit{0, 3.0, 6.0}));
  EXPECT_NEAR(agent.reward, 7.0, 1e-9);
  EXPECT_EQ(agent.path.points.front().point_in_map, (Vector2d{0.0, 0.0}));
  EXPECT_NEAR(pose_at(agent.path, 1.5).x, 1.5, 1e-9);
  EXPECT_NEAR(pose_at(agent.path, 9.0).x, 3.0, 1e-9);
  const auto& drain = plan->drains[0];
  // Full until the source is entered, straight down to empty, and so to the end.
  ASSERT_EQ(drain.size(), 4U);
  for (const auto& [index, time_s, left] : {std::tuple{0U, 0.0, 7.0}, {1U, 2.5, 7.0}, {2U, 6.0, 0.0}}) {
    EXPECT_NEAR(drain[index].time_s, time_s, 1e-9);
    EXPECT_NEAR(drain[index].left, left, 1e-9);
  }
  EXPECT_DOUBLE_EQ(drain.back().left, 0.0);
  ASSERT_FALSE(plan->record.events.empty());
  EXPECT_EQ(plan->record.events.front().kind, RewardEvent::Kind::Exhausted);
  EXPECT_NEAR(plan->record.events.front().time_s, 6.0, 1e-9);
}

TEST(TaskReplay, PlansAreAlikeIfEverybodyWalksTheSameWay) {
  const TimedPath east{{{0.0, {0.0, 0.0}}, {30.0, {30.0, 0.0}}}};
  const TimedPath beside{{{0.0, {0.0, 1.0}}, {30.0, {30.0, 1.0}}}};
  const TimedPath west{{{0.0, {0.0, 0.0}}, {30.0, {-30.0, 0.0}}}};
  EXPECT_TRUE(walks_like({east, west}, {beside, west}));
  EXPECT_FALSE(walks_like({east, west}, {beside, east}));
}

TEST(TaskReplay, ARejectedPlanIsNotProposedAgain) {
  // Two equal prizes on both sides; the first plan is rejected.
  TaskProblem problem =
      task_of({task_agent("a", 0.0, 0.0)}, {spot("l", -20.0, 0.0, 1.0), spot("r", 20.0, 0.0, 1.0)}, {}, 30.0);
  const auto first = plan_task(problem, 200, Rng{1});
  ASSERT_TRUE(first);
  problem.rejected = {{first->agents[0].path}};
  const auto second = plan_task(problem, 200, Rng{1});
  ASSERT_TRUE(second);
  EXPECT_NE(visits_of(problem, *first, 0), visits_of(problem, *second, 0));
  EXPECT_NEAR(second->value, first->value, 1e-9);
}

TEST(TaskReplay, CountsWhatIsAsInThePlanInExecution) {
  const TaskProblem problem =
      task_of({task_agent("a", 0.0, 0.0)}, {spot("s", 1.0, 0.0, 1.0), spot("t", 2.0, 0.0, 1.0)}, {}, 9.0);
  TaskAction first;
  first.kind = TaskActionKind::Visit;
  first.agent = 0;
  first.source = 0;
  TaskAction second = first;
  second.source = 1;
  EXPECT_EQ(visits_in_common(problem.world, {first, second}, {{"s", "t"}}), 2U);
  EXPECT_EQ(visits_in_common(problem.world, {second, first}, {{"s", "t"}}), 0U);
  EXPECT_EQ(visits_in_common(problem.world, {first, second}, {{"s"}}), 1U);
}

}  // namespace
}  // namespace tandem
