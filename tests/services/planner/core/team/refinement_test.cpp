#include "services/planner/core/team/refinement.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

struct Hall {
  SearchCase search{empty_room(16, 10), {3, 3}, {test_robot(), test_person()}};
  PreparedProblem prepared{search.problem};
  TeamGround ground = team_ground(prepared);
  RouteValue value{ground};
};

TEST(Refinement, NeverForgetsTheBestAndMakesBadRoutesMuchBetter) {
  Hall hall;
  const Routes bad{{5, 0, 4}, {3, 1, 6}};
  const double bad_s = hall.value.value_s(bad);
  Refinement refinement(hall.ground, hall.value, {});
  refinement.restart(bad, bad_s);
  Rng rng{1};
  double last_s = bad_s;
  for (int i = 0; i < 10; ++i) {
    refinement.improve(200, rng);
    EXPECT_LE(refinement.best_s(), last_s);
    last_s = refinement.best_s();
  }
  EXPECT_LT(last_s, 0.8 * bad_s);
  EXPECT_DOUBLE_EQ(hall.value.value_s(refinement.best()), last_s);
}

TEST(Refinement, APlaceUpToAFixedGoalStaysAsItIs) {
  SearchCase search(empty_room(16, 10), {3, 3}, {test_person()});
  search.problem.members[0].goal = Eigen::Vector2d{12, 8};
  const PreparedProblem prepared(search.problem);
  const TeamGround ground = team_ground(prepared);
  RouteValue value(ground);
  const int goal = *prepared.members()[0].goal;
  const Routes routes{{2, goal, 0, 1, 3}};
  Refinement refinement(ground, value, {});
  refinement.restart(routes, value.value_s(routes));
  Rng rng{1};
  refinement.improve(2000, rng);
  ASSERT_GE(refinement.best()[0].size(), 2U);
  EXPECT_EQ(refinement.best()[0][0], 2);
  EXPECT_EQ(refinement.best()[0][1], goal);
}

TEST(Refinement, EqualRandomNumbersGiveEqualRoutes) {
  Hall hall;
  const Routes routes{{0, 1, 2}, {3, 4}};
  const auto refined = [&](std::uint64_t seed) {
    Refinement refinement(hall.ground, hall.value, {});
    refinement.restart(routes, hall.value.value_s(routes));
    Rng rng{seed};
    refinement.improve(1000, rng);
    return refinement.best();
  };
  EXPECT_EQ(refined(7), refined(7));
}

}  // namespace
}  // namespace tandem
