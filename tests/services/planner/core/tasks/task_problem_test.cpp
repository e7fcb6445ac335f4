#include "services/planner/core/tasks/task_problem.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/room.hpp"
#include "tests/services/planner/support/tasks.hpp"

namespace tandem {
namespace {

TaskProblem problem_with(int agents, int sources) {
  std::vector<TaskAgent> team;
  for (int a = 0; a < agents; ++a) team.push_back(task_agent("a" + std::to_string(a), a, 0.0));
  std::vector<RewardSource> spots;
  for (int s = 0; s < sources; ++s) spots.push_back(spot("s" + std::to_string(s), s, 2.0, 1.0));
  return task_of(std::move(team), std::move(spots), {}, 10.0);
}

TEST(TaskProblem, HoldsAsManyAsCanBePlanned) {
  EXPECT_EQ(problem_of(problem_with(8, 256)), std::nullopt);
  EXPECT_EQ(problem_of(problem_with(9, 1)), "a task is for at most eight agents");
  EXPECT_EQ(problem_of(problem_with(1, 257)), "a task has at most 256 sources");
}

TEST(TaskProblem, AnAgentMovesOnALayerThatThereIs) {
  TaskProblem problem = problem_with(2, 1);
  problem.agents[1].searcher.layer = 1;
  EXPECT_EQ(problem_of(problem), std::nullopt);  // an open plane has them all
  problem.layers = {empty_room(4, 4)};
  EXPECT_EQ(problem_of(problem), "agent a1 moves on a layer that there is not");
  problem.layers.push_back(empty_room(4, 4));
  EXPECT_EQ(problem_of(problem), std::nullopt);
}

TEST(TaskProblem, WhatIsWrongWithTheWorldIsSaidWithItsPlace) {
  TaskProblem problem = problem_with(1, 2);
  problem.world.sources[1].id = problem.world.sources[0].id;
  const auto wrong = problem_of(problem.world);
  ASSERT_TRUE(wrong);
  EXPECT_EQ(problem_of(problem), wrong->where + ": " + wrong->what);
}

}  // namespace
}  // namespace tandem
