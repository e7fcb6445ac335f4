#include "services/planner/core/baselines/dec_mcts_planner.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/search_corridor.hpp"

namespace tandem {
namespace {

TEST(DecMctsPlanner, T16TwoRobotsComeToSplit) {
  SearchCase search = corridor(2);
  place_mass(search, 2.75, 0.2, 10.25, 0.8);
  search.problem.horizon_s = 40.0;
  DecMctsPlanner planner({});
  const JointPlan plan = plan_with(planner, search.problem, 400, 1);
  EXPECT_NEAR(plan.forecast.expected_time_s, 0.8 * 5.0 + 0.2 * 1.5, 1.0);
}

TEST(DecMctsPlanner, MoreRolloutsNeverGiveAWorsePlanHoweverTheyAreCut) {
  SearchCase search = corridor(2);
  DecMctsPlanner whole({});
  const JointPlan a = plan_with(whole, search.problem, 100, 5);
  DecMctsPlanner pieces({});
  pieces.begin(search.problem, Rng{5});
  double last_s = pieces.best().value_s;
  for (int i = 0; i < 20; ++i) {
    pieces.run(5, {});
    EXPECT_LE(pieces.best().value_s, last_s + 1e-9);
    last_s = pieces.best().value_s;
  }
  EXPECT_EQ(a.value_s, last_s);
}

}  // namespace
}  // namespace tandem
