#include "bench/planning/srs_worlds/task_oracle.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/tasks.hpp"

namespace tandem::bench {
namespace {

// 10 s: the left one (5 m, pays 4) or both right ones (2 m and 3 m more, pay 3 and 2), not all.
TaskProblem left_or_right() {
  return task_of({task_agent("a", 0.0, 0.0)},
                 {spot("l", -5.0, 0.0, 4.0), spot("r", 2.0, 0.0, 3.0), spot("rr", 5.0, 0.0, 2.0)}, {}, 10.0);
}

TEST(TaskOracle, FindsTheBestOfAllOrders) {
  // r first, then l: 2 + 7 = 9 s, pays 7; r, rr and no more: 5; l, r: 12 s.
  for (const auto pruning : {OraclePruning::None, OraclePruning::Bound}) {
    const auto best = best_task_value(left_or_right(), pruning, 1'000'000);
    EXPECT_TRUE(best.is_complete);
    EXPECT_NEAR(best.value, 7.0, 1e-9);
  }
}

TEST(TaskOracle, PruningLooksAtLess) {
  const auto all = best_task_value(left_or_right(), OraclePruning::None, 1'000'000);
  const auto pruned = best_task_value(left_or_right(), OraclePruning::Bound, 1'000'000);
  EXPECT_LT(pruned.decisions, all.decisions);
}

TEST(TaskOracle, SaysWhenItRanOutOfDecisions) {
  EXPECT_FALSE(best_task_value(left_or_right(), OraclePruning::None, 3).is_complete);
}

}  // namespace
}  // namespace tandem::bench
