#include "services/planner/core/tasks/task_bound.hpp"

#include <gtest/gtest.h>

#include "bench/planning/srs_worlds/srs_world.hpp"
#include "bench/planning/srs_worlds/task_oracle.hpp"
#include "tests/services/planner/support/tasks.hpp"

namespace tandem {
namespace {

double bound_at_start(const TaskProblem& problem) {
  TaskModel model{problem};
  TaskBound bound{model};
  return bound(model.start());
}

TEST(TaskBound, CountsNoMoreThanThePoolAndTheTimeThereIs) {
  // 10 m there: 2 of 12 s are left at a rate of 3.
  EXPECT_NEAR(
      bound_at_start(task_of({task_agent("a", 0.0, 0.0)}, {disc_source("s", {10.0, 0.0}, 0.001, 3.0, 50.0)}, {}, 12.0)),
      6.0, 0.1);
  EXPECT_NEAR(
      bound_at_start(task_of({task_agent("a", 0.0, 0.0)}, {disc_source("s", {10.0, 0.0}, 0.001, 3.0, 5.0)}, {}, 30.0)),
      5.0, 1e-6);
}

TEST(TaskBound, KnowsThatOneAgentCannotBeInTwoPlacesAtOnce) {
  // Two sources 16 m apart, each 8 m away and 1/s for 10 s: alone 10 each, but there are 20 s.
  const auto sources = std::vector<RewardSource>{disc_source("l", {-8.0, 0.0}, 0.001, 1.0, 10.0),
                                                 disc_source("r", {8.0, 0.0}, 0.001, 1.0, 10.0)};
  EXPECT_LT(bound_at_start(task_of({task_agent("a", 0.0, 0.0)}, sources, {}, 20.0)), 13.0);
  EXPECT_NEAR(bound_at_start(task_of({task_agent("a", 0.0, 0.0), task_agent("b", 0.0, 0.0)}, sources, {}, 20.0)), 20.0,
              1e-6);
}

TEST(TaskBound, KnowsThatATwinIsNoSecondReward) {
  const TaskProblem problem =
      task_of({task_agent("a", 0.0, 0.0)}, {spot("one", 1.0, 0.0, 5.0), spot("two", 0.0, 1.0, 5.0)},
              {codependent("one", "two", 1.0)}, 20.0);
  EXPECT_NEAR(bound_at_start(problem), 5.0, 1e-6);
}

TEST(TaskBound, IsNeverBelowWhatExhaustiveSearchFinds) {
  for (std::uint64_t seed = 100; seed < 140; ++seed) {
    bench::SrsWorldOptions options;
    options.least_sources = 2;
    options.most_sources = 3;
    options.most_agents = 2;
    const TaskProblem problem = bench::random_srs_task(seed, options);
    const auto all = bench::best_task_value(problem, bench::OraclePruning::None, 200'000);
    EXPECT_GE(bound_at_start(problem), all.value - 1e-9) << "seed " << seed;
  }
}

}  // namespace
}  // namespace tandem
