#include "services/planner/core/tasks/task_courses.hpp"

#include <gtest/gtest.h>

#include "bench/planning/srs_worlds/srs_world.hpp"
#include "services/common/random.hpp"
#include "tests/services/planner/support/tasks.hpp"

namespace tandem {
namespace {

// Two spots, one on each side: 2 m and 3 m away at 1 m/s.
TaskProblem two_spots() {
  return task_of({task_agent("a", 0.0, 0.0)}, {spot("left", -2.0, 0.0, 4.0), spot("right", 3.0, 0.0, 5.0)}, {}, 20.0);
}

TEST(TaskCourses, LeadWhereTheModelLeads) {
  const TaskProblem problem = two_spots();
  TaskModel model{problem};
  TaskCourses courses{model, model.start()};
  ASSERT_EQ(courses.actions(TaskCourses::kStart).size(), 3U);  // left, right, wait
  const std::int32_t at_left = courses.after(TaskCourses::kStart, 0);
  EXPECT_NEAR(courses.state(at_left).value, 4.0, 1e-9);
  ASSERT_EQ(courses.actions(at_left).size(), 2U);  // right, wait
  const std::int32_t end = courses.after(courses.after(at_left, 0), 0);
  EXPECT_NEAR(courses.state(end).value, 9.0, 1e-9);
  EXPECT_TRUE(courses.actions(end).empty());  // over
}

TEST(TaskCourses, TheSameDecisionsLeadToTheSameState) {
  const TaskProblem problem = two_spots();
  TaskModel model{problem};
  TaskCourses courses{model, model.start()};
  const std::int32_t left = courses.after(TaskCourses::kStart, 0);
  const std::int32_t right = courses.after(TaskCourses::kStart, 1);
  EXPECT_NE(left, right);
  EXPECT_EQ(courses.size(), 3U);
  EXPECT_EQ(courses.after(TaskCourses::kStart, 0), left);
  EXPECT_EQ(courses.after(TaskCourses::kStart, 1), right);
  EXPECT_EQ(courses.size(), 3U);
}

TEST(TaskCourses, AChoiceIsNotedPerStateUntilAllIsForgotten) {
  const TaskProblem problem = two_spots();
  TaskModel model{problem};
  TaskCourses courses{model, model.start()};
  const std::int32_t left = courses.after(TaskCourses::kStart, 0);
  EXPECT_EQ(courses.noted_choice(left), -1);
  courses.noted_choice(left) = 1;
  EXPECT_EQ(courses.noted_choice(left), 1);
  EXPECT_EQ(courses.noted_choice(TaskCourses::kStart), -1);
  courses.forget();
  EXPECT_EQ(courses.size(), 1U);
  // The memory is used again, by another state.
  const std::int32_t right = courses.after(TaskCourses::kStart, 1);
  EXPECT_EQ(courses.noted_choice(right), -1);
  EXPECT_NEAR(courses.state(right).value, 5.0, 1e-9);
  ASSERT_EQ(courses.actions(right).size(), 2U);
  EXPECT_EQ(courses.actions(right)[0].source, 0);
}

TEST(TaskCourses, RandomWalksEndAsInTheModelBitForBit) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const TaskProblem problem = bench::random_srs_task(seed);
    TaskModel model{problem};
    TaskCourses courses{model, model.start()};
    Rng rng{seed};
    for (int walk = 0; walk < 30; ++walk) {
      if (courses.size() > 100) courses.forget();
      TaskState state = model.start();
      std::vector<TaskAction> actions;
      std::int32_t moment = TaskCourses::kStart;
      while (model.decider(state) != TaskModel::kNobody) {
        model.actions(state, actions);
        ASSERT_EQ(courses.actions(moment), actions) << "seed " << seed;
        const std::size_t chosen = rng.index(actions.size());
        state = model.after(state, actions[chosen]);
        moment = courses.after(moment, chosen);
      }
      EXPECT_EQ(courses.state(moment).value, state.value) << "seed " << seed;
      EXPECT_EQ(courses.state(moment).rewards, state.rewards) << "seed " << seed;
      EXPECT_TRUE(courses.actions(moment).empty()) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace tandem
