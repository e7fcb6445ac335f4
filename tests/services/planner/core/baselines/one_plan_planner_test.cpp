#include "services/planner/core/baselines/one_plan_planner.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/search_corridor.hpp"

namespace tandem {
namespace {

/// Everybody goes to the nearest place that shows something new, once.
class OneStep final : public OnePlanPlanner {
 private:
  [[nodiscard]] Routes routes(const PreparedProblem& problem) const override {
    TeamWalk walk(problem, 1);
    Routes routes(problem.members().size());
    for (std::size_t m = 0; m < routes.size(); ++m) {
      const auto options = walk.options(static_cast<int>(m));
      if (!options.empty()) routes[m].push_back(options.front().place);
    }
    return routes;
  }
};

TEST(OnePlanPlanner, ThePlanOfItsRoutesIsThereAtOnceAndStays) {
  SearchCase search = corridor(2);
  place_mass(search, 2.75, 0.2, 10.25, 0.8);
  OneStep planner;
  planner.begin(search.problem, Rng{1});
  const JointPlan first = planner.best();
  EXPECT_DOUBLE_EQ(first.forecast.probability_found, 0.2);  // both went to the nearer one
  planner.run(100, {});
  EXPECT_EQ(planner.rollouts(), 0);
  EXPECT_EQ(planner.best().value_s, first.value_s);
}

TEST(OnePlanPlanner, ChanceChangesNothing) {
  SearchCase search = corridor(1);
  OneStep planner;
  EXPECT_EQ(plan_with(planner, search.problem, 0, 1).value_s, plan_with(planner, search.problem, 0, 2).value_s);
}

TEST(OnePlanPlanner, ItBeginsAnewWithAnotherProblem) {
  SearchCase search = corridor(1);
  place_mass(search, 2.75, 1.0, 10.25, 0.0);
  OneStep planner;
  EXPECT_LT(pose_at(plan_with(planner, search.problem, 0, 1).paths[0], 2.0).x, 4.0);
  place_mass(search, 2.75, 0.0, 10.25, 1.0);
  EXPECT_GT(pose_at(plan_with(planner, search.problem, 0, 1).paths[0], 2.0).x, 6.0);
}

}  // namespace
}  // namespace tandem
