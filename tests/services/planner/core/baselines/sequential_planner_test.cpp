#include "services/planner/core/baselines/sequential_planner.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/search_corridor.hpp"

namespace tandem {
namespace {

TEST(SequentialPlanner, TheFirstTakesTheBestForItselfAndTheSecondWhatIsLeft) {
  SearchCase search = corridor(2);
  place_mass(search, 2.75, 0.1, 10.25, 0.9);
  SequentialPlanner planner({});
  const JointPlan plan = plan_with(planner, search.problem, 200, 1);
  EXPECT_GT(pose_at(plan.paths[0], 3.0).x, 7.0);
  EXPECT_LT(pose_at(plan.paths[1], 1.5).x, 3.5);
}

TEST(SequentialPlanner, MoreRolloutsNeverGiveAWorsePlanHoweverTheyAreCut) {
  SearchCase search = corridor(2);
  SequentialPlanner whole({});
  const JointPlan a = plan_with(whole, search.problem, 200, 5);
  SequentialPlanner pieces({});
  pieces.begin(search.problem, Rng{5});
  double last_s = pieces.best().value_s;
  for (int i = 0; i < 20; ++i) {
    pieces.run(10, {});
    EXPECT_LE(pieces.best().value_s, last_s);
    last_s = pieces.best().value_s;
  }
  EXPECT_EQ(a.value_s, last_s);
}

TEST(SequentialPlanner, OnlyTheFastestIfAskedFor) {
  SearchCase search = corridor(2);
  SequentialOptions options;
  options.only_fastest = true;
  SequentialPlanner planner(options);
  const JointPlan plan = plan_with(planner, search.problem, 50, 1);
  EXPECT_GT(plan.paths[0].duration_s(), 5.0);
  EXPECT_EQ(plan.paths[1].duration_s(), 0.0);
}

}  // namespace
}  // namespace tandem
