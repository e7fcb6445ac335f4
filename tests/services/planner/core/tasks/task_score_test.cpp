#include "services/planner/core/tasks/task_score.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/tasks.hpp"

namespace tandem {
namespace {

std::vector<double> scores_of(const TaskProblem& problem) {
  TaskModel model{problem};
  TaskScore score{model};
  const TaskState start = model.start();
  std::vector<TaskAction> actions;
  model.actions(start, actions);
  std::vector<double> scores;
  for (const TaskAction& action : actions) scores.push_back(score(start, action, 1.0));
  return scores;
}

TEST(TaskScore, PrefersTheNearAndTheRich) {
  const auto near_far = scores_of(
      task_of({task_agent("a", 0.0, 0.0)}, {spot("near", 1.0, 0.0, 2.0), spot("far", 9.0, 0.0, 2.0)}, {}, 30.0));
  EXPECT_GT(near_far[0], near_far[1]);
  const auto poor_rich = scores_of(
      task_of({task_agent("a", 0.0, 0.0)}, {spot("poor", 3.0, 0.0, 1.0), spot("rich", -3.0, 0.0, 2.0)}, {}, 30.0));
  EXPECT_LT(poor_rich[0], poor_rich[1]);
}

TEST(TaskScore, PrefersWhatOpensAnotherAndPutsOffWhatSilencesOne) {
  const std::vector<RewardSource> sources{spot("i", 3.0, 0.0, 1.0), spot("j", -3.0, 0.0, 1.0)};
  const auto opening = scores_of(task_of({task_agent("a", 0.0, 0.0)}, sources, {strict("i", "j")}, 30.0));
  EXPECT_GT(opening[0], opening[1]);
  const auto silencing = scores_of(task_of({task_agent("a", 0.0, 0.0)}, sources, {soft("i", "j")}, 30.0));
  EXPECT_GT(silencing[0], silencing[1]);
}

TEST(TaskScore, IsPositiveForEverything) {
  const auto scores = scores_of(task_of(
      {task_agent("a", 0.0, 0.0)}, {spot("s", 5.0, 0.0, 1.0), disc_source("fire", {5.0, 0.0}, 2.0, -9.0)}, {}, 30.0));
  for (const double score : scores) EXPECT_GT(score, 0.0);
}

}  // namespace
}  // namespace tandem
