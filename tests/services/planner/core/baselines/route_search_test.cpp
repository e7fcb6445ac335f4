#include "services/planner/core/baselines/route_search.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/search_corridor.hpp"

namespace tandem {
namespace {

TEST(RouteSearch, FindsTheLikelyPlaceFirstThoughItIsFarther) {
  SearchCase search = corridor(1);
  place_mass(search, 2.75, 0.2, 10.25, 0.8);
  search.problem.horizon_s = 40.0;
  const PreparedProblem problem(search.problem);
  SearchObjective objective(search.problem.masses, 40.0, 40.0);
  RouteSearchOptions options;
  options.spread = 1.0;  // anything that shows something
  RouteSearch routes(problem, objective, options, Routes(1), 0);
  EXPECT_DOUBLE_EQ(routes.expected_time_s(), 80.0);  // standing still finds nothing
  Rng rng{1};
  double last_s = routes.expected_time_s();
  for (int i = 0; i < 100; ++i) {
    routes.improve(rng);
    EXPECT_LE(routes.expected_time_s(), last_s);
    last_s = routes.expected_time_s();
  }
  EXPECT_NEAR(last_s, 0.8 * 5.0 + 0.2 * (5.0 + 6.5), 1.0);
}

TEST(RouteSearch, GreedyAtRandomTakesOnlyWhatIsNearlyTheBest) {
  const std::vector<WalkOption> options{{1, 1.0, 1.0}, {2, 0.9, 1.0}, {3, 0.1, 1.0}};
  Rng rng{2};
  RouteSearchOptions search;
  search.spread = 0.2;
  for (int i = 0; i < 50; ++i) EXPECT_NE(greedy_at_random(options, search, rng), 3);
  EXPECT_EQ(greedy_at_random({}, search, rng), -1);
}

}  // namespace
}  // namespace tandem
