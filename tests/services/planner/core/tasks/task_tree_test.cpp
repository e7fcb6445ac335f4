#include "services/planner/core/tasks/task_tree.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/services/planner/support/tasks.hpp"

namespace tandem {
namespace {

/// Keeps the best value, and counts what it was offered.
class Collector : public TaskIncumbent {
 public:
  void offer(const std::vector<TaskAction>& decisions, const TaskState& final_state) override {
    ++offers;
    if (final_state.value <= best) return;
    best = final_state.value;
    best_decisions = decisions;
  }
  [[nodiscard]] bool can_be_beaten_by(double bound, std::int64_t /*least_makespan_ms*/) const override {
    return bound > best + 1e-7;
  }
  [[nodiscard]] double value() const override { return best; }
  [[nodiscard]] const std::vector<TaskAction>& decisions() const override { return best_decisions; }

  int offers = 0;
  double best = -std::numeric_limits<double>::infinity();
  std::vector<TaskAction> best_decisions;
};

// 10 s: the left one (5 m, pays 4) or both right ones (2 m and 3 m more, pay 3 and 2), not all: r, then l, pays 7.
TaskProblem left_or_right() {
  return task_of({task_agent("a", 0.0, 0.0)},
                 {spot("l", -5.0, 0.0, 4.0), spot("r", 2.0, 0.0, 3.0), spot("rr", 5.0, 0.0, 2.0)}, {}, 10.0);
}

TEST(TaskTree, SearchesASmallWorldToTheEnd) {
  const TaskProblem problem = left_or_right();
  TaskModel model{problem};
  Collector collector;
  TaskTree tree{model, collector};
  Rng rng{1};
  int rollouts = 0;
  while (!tree.is_finished() && rollouts < 1000) {
    tree.roll_out(rng);
    ++rollouts;
  }
  EXPECT_TRUE(tree.is_finished());
  EXPECT_NEAR(collector.best, 7.0, 1e-9);
  EXPECT_NEAR(tree.bound(), 7.0, 1e-6);
}

TEST(TaskTree, TheGreedyPlansComeFirst) {
  const TaskProblem problem = left_or_right();
  TaskModel model{problem};
  Collector collector;
  TaskTree tree{model, collector};
  tree.offer_greedy_plans();
  EXPECT_GE(collector.offers, 2);
  EXPECT_GT(collector.best, 0.0);
}

TEST(TaskTree, KeepsItsBoundWithoutMemoryForMoreNodes) {
  const TaskProblem problem = left_or_right();
  TaskModel model{problem};
  Collector collector;
  TaskTreeOptions options;
  options.most_nodes = 3;
  TaskTree tree{model, collector, options};
  Rng rng{1};
  for (int i = 0; i < 200; ++i) tree.roll_out(rng);
  EXPECT_NEAR(collector.best, 7.0, 1e-9);
  EXPECT_GE(tree.bound(), 7.0 - 1e-9);
}

}  // namespace
}  // namespace tandem
