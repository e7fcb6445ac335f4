#include "services/planner/core/tasks/assignment_bound.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tandem {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// A pool that any of `agents` would empty in the same time.
PoolItems pool(double value, double time_s, std::size_t agents) {
  PoolItem item;
  for (std::size_t a = 0; a < agents; ++a) item.offers[a] = {value, time_s, 1.0};
  return {{item}, kNoLimit};
}

TEST(AssignmentBound, TakesTheMostWorthwhileThatTheTimeIsEnoughFor) {
  // 10 s: the pool of 6 for 4 s and, of the pool of 6 for 12 s, a half.
  AssignmentBound bound;
  EXPECT_NEAR(bound({pool(6.0, 4.0, 1), pool(6.0, 12.0, 1)}, {10.0}), 9.0, 0.1);
}

TEST(AssignmentBound, TwoAgentsHaveTwiceTheTime) {
  AssignmentBound bound;
  EXPECT_NEAR(bound({pool(6.0, 10.0, 2), pool(6.0, 10.0, 2)}, {10.0, 10.0}), 12.0, 1e-9);
  EXPECT_NEAR(bound({pool(6.0, 10.0, 2), pool(6.0, 10.0, 2)}, {10.0, 0.0}), 6.0, 0.1);
}

TEST(AssignmentBound, OneAgentsTimeDoesNotServeAnotherAgentsPool) {
  // Only agent 0 can use the two pools; agent 1 has all the time.
  AssignmentBound bound;
  EXPECT_NEAR(bound({pool(5.0, 10.0, 1), pool(5.0, 10.0, 1)}, {10.0, 100.0}), 5.0, 0.1);
}

TEST(AssignmentBound, TwinsGiveNoMoreThanOne) {
  PoolItems twins = pool(5.0, 1.0, 1);
  twins.items.push_back(twins.items.front());
  twins.most = 5.0;
  AssignmentBound bound;
  EXPECT_NEAR(bound({twins}, {100.0}), 5.0, 1e-9);
}

TEST(AssignmentBound, IsNeverBelowAnAssignmentThatFits) {
  // Whole pools in the order given, while there is time.
  const std::vector<PoolItems> pools{pool(3.0, 2.0, 2), pool(4.0, 5.0, 2), pool(7.0, 6.0, 2)};
  AssignmentBound bound;
  EXPECT_GE(bound(pools, {7.0, 6.0}), 3.0 + 4.0 + 7.0 - 1e-9);
  EXPECT_GE(bound(pools, {6.0, 0.0}), 7.0 - 1e-9);
}

}  // namespace
}  // namespace tandem
