#include "services/planner/core/team/route_value.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "services/planner/core/team/joint_walk.hpp"
#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

constexpr double kFirstSight = std::numeric_limits<double>::infinity();

Searcher sharp(Searcher searcher, double speed_mps) {
  searcher.detection_rate_per_s = kFirstSight;
  searcher.field_of_view_rad = 2.0 * std::numbers::pi;
  searcher.view_min_m = 0.0;
  searcher.view_max_m = 2.0;
  searcher.speed_mps = speed_mps;
  return searcher;
}

Routes random_routes(const TeamGround& ground, Rng& rng) {
  JointWalk walk(ground, {});
  for (int m = walk.next_member(); m >= 0; m = walk.next_member()) {
    const auto choices = walk.choices(m, 6);
    walk.choose(m, choices[rng.index(choices.size())].place);
  }
  return walk.routes();
}

TEST(RouteValue, EqualsTheObjectiveWhereSeenIsFound) {
  SearchCase search(empty_room(16, 10), {3, 3}, {sharp(test_person(), 0.75), sharp(test_person(), 0.5)}, 1.6);
  const PreparedProblem prepared(search.problem);
  const TeamGround ground = team_ground(prepared);
  ASSERT_TRUE(ground.first_sight);
  RouteValue value(ground);
  Rng rng{1};
  for (int i = 0; i < 20; ++i) {
    const Routes routes = random_routes(ground, rng);
    EXPECT_NEAR(value.value_s(routes), value.exact_s(routes), 1e-3) << i;
    EXPECT_NEAR(value.value_s(routes), prepared.plan(routes).value_s, 1e-3) << i;
  }
}

TEST(RouteValue, CountsNothingSeenOnAnEmptyBattery) {
  for (const double rate_per_s : {kFirstSight, 0.3}) {
    Searcher drone = sharp(test_person(), 0.75);
    drone.detection_rate_per_s = rate_per_s;
    std::vector<Searcher> team{drone};
    if (std::isinf(rate_per_s)) team.push_back(sharp(test_person(), 0.5));  // two at a rate: only nearly exact
    SearchCase search(empty_room(16, 10), {3, 3}, team, 1.6);
    Rng rng{3};
    for (int i = 0; i < 20; ++i) {
      search.problem.members[0].battery_s = 100.0;
      const PreparedProblem full(search.problem);
      const TeamGround full_ground = team_ground(full);
      const Routes routes = random_routes(full_ground, rng);
      const double full_s = RouteValue(full_ground).value_s(routes);

      search.problem.members[0].battery_s = rng.uniform(2.0, 10.0);
      const PreparedProblem prepared(search.problem);
      const TeamGround ground = team_ground(prepared);
      const double value_s = RouteValue(ground).value_s(routes);
      EXPECT_GT(value_s, full_s + 0.1) << rate_per_s << " " << i;
      EXPECT_NEAR(value_s, prepared.plan(routes).value_s, 1e-2) << rate_per_s << " " << i;
      EXPECT_NEAR(value_s, RouteValue(ground).exact_s(routes), 1e-2) << rate_per_s << " " << i;
    }
  }
}

TEST(RouteValue, EqualsTheObjectiveOfOneWhoDetectsAtARate) {
  SearchCase search(empty_room(16, 10), {3, 3}, {test_robot()});
  const PreparedProblem prepared(search.problem);
  const TeamGround ground = team_ground(prepared);
  RouteValue value(ground);
  Rng rng{2};
  for (int i = 0; i < 20; ++i) {
    const Routes routes = random_routes(ground, rng);
    EXPECT_NEAR(value.value_s(routes), prepared.plan(routes).value_s, 1e-2) << i;
  }
}

TEST(RouteValue, IsCloseToTheObjectiveOfTwoWhoLookAtOneCellAtOnce) {
  SearchCase search(empty_room(16, 10), {3, 3}, {test_robot(), test_person()});
  const PreparedProblem prepared(search.problem);
  const TeamGround ground = team_ground(prepared);
  RouteValue value(ground);
  Rng rng{3};
  for (int i = 0; i < 20; ++i) {
    const Routes routes = random_routes(ground, rng);
    const double exact_s = prepared.plan(routes).value_s;
    EXPECT_NEAR(value.value_s(routes), exact_s, 0.05 * exact_s) << i;
  }
}

TEST(RouteValue, CountsHypothesesAndRejectedPlansAsTheObjectiveDoes) {
  SearchCase search(empty_room(16, 10), {3, 3}, {sharp(test_person(), 0.75), sharp(test_person(), 0.5)}, 1.6);
  search.problem.members[0].hypotheses.push_back({0.3, {{{0.0, {3, 3}}, {10.0, {10, 8}}}}});
  Rng rng{4};
  {
    const PreparedProblem prepared(search.problem);
    const TeamGround ground = team_ground(prepared);
    const Routes routes = random_routes(ground, rng);
    EXPECT_NEAR(RouteValue(ground).value_s(routes), prepared.plan(routes).value_s, 1e-3);
    search.problem.rejected.push_back(prepared.plan(routes).paths);
  }
  const PreparedProblem prepared(search.problem);
  const TeamGround ground = team_ground(prepared);
  Rng again{4};
  EXPECT_GT(RouteValue(ground).value_s(random_routes(ground, again)), kRejectedPenalty_s);
}

}  // namespace
}  // namespace tandem
