#include "services/planner/core/tasks/task_planner.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/tasks.hpp"

namespace tandem {
namespace {

// A corridor along x: key at 2, door at -2, start at 0, 1 m/s. Key first (2 s), then 4 m back: 6 s.
TaskProblem key_and_door() {
  return task_of({task_agent("a", 0.0, 0.0)}, {spot("key", 2.0, 0.0, 1.0), spot("door", -2.0, 0.0, 10.0)},
                 {strict("key", "door")}, 20.0);
}

TEST(TaskPlanner, T6FetchesTheKeyBeforeTheDoor) {
  const TaskProblem problem = key_and_door();
  const auto plan = plan_task(problem, 1000, Rng{1});
  ASSERT_TRUE(plan);
  EXPECT_EQ(visits_of(problem, *plan, 0), "key door");
  EXPECT_NEAR(plan->value, 11.0, 1e-9);
  EXPECT_NEAR(plan->makespan_s, 6.0, 0.01);
  EXPECT_TRUE(plan->is_proven());
}

// The switch opens the panel. a1 is 2 m from the switch, a0 5 m from the panel, 1 m/s.
TaskProblem light_and_panel() {
  TaskProblem problem =
      task_of({task_agent("a0", 0.0, 0.0), task_agent("a1", 0.0, 5.0)},
              {spot("switch", 2.0, 5.0, 1.0), spot("panel", 5.0, 0.0, 10.0, {"a0"})}, {strict("switch", "panel")}, 30.0);
  return problem;
}

TEST(TaskPlanner, T9TheMateSwitchesTheLightOnWhileTheReaderGoesToThePanel) {
  const TaskProblem problem = light_and_panel();
  const auto plan = plan_task(problem, 1000, Rng{1});
  ASSERT_TRUE(plan);
  EXPECT_EQ(visits_of(problem, *plan, 0), "panel");
  EXPECT_EQ(visits_of(problem, *plan, 1), "switch");
  EXPECT_NEAR(plan->value, 11.0, 1e-9);
  EXPECT_NEAR(plan->makespan_s, 5.0, 0.01);
  EXPECT_TRUE(plan->is_proven());
}

}  // namespace
}  // namespace tandem
