#include "services/planner/core/tasks/task_branch_and_bound.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "bench/planning/srs_worlds/srs_world.hpp"
#include "bench/planning/srs_worlds/task_oracle.hpp"
#include "tests/services/planner/support/tasks.hpp"

namespace tandem {
namespace {

/// Keeps the best value.
class Best : public TaskIncumbent {
 public:
  void offer(const std::vector<TaskAction>& decisions, const TaskState& final_state) override {
    if (final_state.value <= best) return;
    best = final_state.value;
    best_decisions = decisions;
  }
  [[nodiscard]] bool can_be_beaten_by(double bound, std::int64_t /*least_makespan_ms*/) const override {
    return bound > best + 1e-7;
  }
  [[nodiscard]] double value() const override { return best; }
  [[nodiscard]] const std::vector<TaskAction>& decisions() const override { return best_decisions; }

  double best = -std::numeric_limits<double>::infinity();
  std::vector<TaskAction> best_decisions;
};

TaskProblem small_world(std::uint64_t seed) {
  bench::SrsWorldOptions options;
  options.least_sources = 2;
  options.most_sources = 3;
  options.most_agents = 2;
  return bench::random_srs_task(seed, options);
}

// 10 s: the left one (5 m, pays 4) or both right ones (2 m and 3 m more, pay 3 and 2), not all: r, then l, pays 7.
TEST(TaskBranchAndBound, FindsAndProvesTheBestPlan) {
  const TaskProblem problem =
      task_of({task_agent("a", 0.0, 0.0)},
              {spot("l", -5.0, 0.0, 4.0), spot("r", 2.0, 0.0, 3.0), spot("rr", 5.0, 0.0, 2.0)}, {}, 10.0);
  TaskModel model{problem};
  Best best;
  TaskBranchAndBound search{model, best};
  EXPECT_FALSE(search.is_finished());
  EXPECT_GE(search.bound(), 7.0);
  search.go_on(1000);
  EXPECT_TRUE(search.is_finished());
  EXPECT_NEAR(best.best, 7.0, 1e-9);
  ASSERT_GE(best.best_decisions.size(), 2U);
  EXPECT_EQ(best.best_decisions[0].source, 1);
  EXPECT_EQ(best.best_decisions[1].source, 0);
}

TEST(TaskBranchAndBound, FindsWhatLookingAtEveryPlanFinds) {
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    const TaskProblem problem = small_world(seed);
    const auto all = bench::best_task_value(problem, bench::OraclePruning::None, 400'000);
    if (!all.is_complete) continue;
    TaskModel model{problem};
    Best best;
    TaskBranchAndBound search{model, best};
    search.go_on(400'000);
    EXPECT_TRUE(search.is_finished()) << "seed " << seed;
    EXPECT_NEAR(best.best, all.value, 1e-6) << "seed " << seed;
  }
}

TEST(TaskBranchAndBound, ItsBoundNeverRisesAndStartsAboveTheBestPlan) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const TaskProblem problem = small_world(seed);
    TaskModel model{problem};
    Best best;
    TaskBranchAndBound search{model, best};
    std::vector<double> bounds;
    for (int i = 0; i < 100'000 && !search.is_finished(); ++i) {
      bounds.push_back(search.bound());
      search.go_on(5);
    }
    ASSERT_TRUE(search.is_finished()) << "seed " << seed;
    for (std::size_t i = 1; i < bounds.size(); ++i) EXPECT_LE(bounds[i], bounds[i - 1]) << "seed " << seed;
    EXPECT_GE(bounds.front(), best.best - 1e-6) << "seed " << seed;
  }
}

TEST(TaskBranchAndBound, InPiecesItLooksAtTheSame) {
  const TaskProblem problem = small_world(3);
  TaskModel model{problem};
  Best one;
  Best other;
  TaskBranchAndBound whole{model, one};
  TaskBranchAndBound pieces{model, other};
  whole.go_on(60);
  for (int i = 0; i < 60; ++i) pieces.go_on(1);
  EXPECT_EQ(whole.bound(), pieces.bound());
  EXPECT_EQ(one.best, other.best);
  EXPECT_EQ(one.best_decisions, other.best_decisions);
}

}  // namespace
}  // namespace tandem
