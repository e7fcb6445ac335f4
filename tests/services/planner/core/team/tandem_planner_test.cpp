#include "services/planner/core/team/tandem_planner.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "services/planner/core/planners/registry.hpp"
#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kSinglePrecision = 1e-6;

/// A hall of 16 m x 10 m with a wall that juts in.
SearchCase hall(std::vector<Searcher> searchers) {
  std::vector<std::string> drawing(22, "#" + std::string(32, '.') + "#");
  drawing.front() = drawing.back() = std::string(34, '#');
  for (std::size_t row = 1; row < 13; ++row) drawing[row][16] = '#';
  return {room(drawing), {3, 3}, std::move(searchers)};
}

JointPlan plan_with(const SearchProblem& problem, int rollouts, std::uint64_t seed) {
  TandemPlanner planner({});
  return plan_with(planner, problem, rollouts, seed);
}

/// All mass in small places near two points.
void place_mass(SearchCase& search, const Vector2d& a, double mass_a, const Vector2d& b, double mass_b) {
  auto& mass = search.problem.masses.front();
  std::fill(mass.begin(), mass.end(), 0.0);
  mass[static_cast<std::size_t>(*search.world().area().cell_at(a))] = mass_a;
  mass[static_cast<std::size_t>(*search.world().area().cell_at(b))] = mass_b;
}

Searcher short_sighted() {
  Searcher agent = test_person();
  agent.view_max_m = 0.6;
  agent.detection_rate_per_s = 100.0;
  agent.speed_mps = 1.0;
  return agent;
}

TEST(TandemPlanner, T15OneAgentGoesToTheLikelyRoomFirstThoughItIsFarther) {
  SearchCase search(empty_room(12, 1), {4.75, 1.0}, {short_sighted()}, 0.7);
  place_mass(search, {2.75, 1.0}, 0.2, {10.25, 1.0}, 0.8);  // 2 m and 5.5 m away, seen from 0.6 m
  search.problem.horizon_s = 30.0;
  const JointPlan plan = plan_with(search.problem, 200, 1);

  const double likely_first_s = 0.8 * 4.9 + 0.2 * (4.9 + 6.3);
  EXPECT_NEAR(plan.forecast.expected_time_s, likely_first_s, 1.0);
  EXPECT_GT(pose_at(plan.paths[0], 4.0).x, 7.0);
}

TEST(TandemPlanner, T16TwoAgentsSplit) {
  SearchCase search(empty_room(12, 1), {4.75, 1.0}, {short_sighted(), short_sighted()}, 0.7);
  place_mass(search, {2.75, 1.0}, 0.2, {10.25, 1.0}, 0.8);
  search.problem.horizon_s = 30.0;
  const JointPlan plan = plan_with(search.problem, 200, 1);

  EXPECT_NEAR(plan.forecast.expected_time_s, 0.8 * 4.9 + 0.2 * 1.4, 1.0);
}

TEST(TandemPlanner, T17AFixedGoalIsReachedAndTheSearchGoesOn) {
  SearchCase search = hall({test_robot(), test_person()});
  const Vector2d corner{15.75, 9.75};
  search.problem.members[1].goal = corner;
  const JointPlan plan = plan_with(search.problem, 50, 1);

  const TimedPath told = path_until(plan.paths[1], plan.goal_reached_s[1]);
  EXPECT_LE((told.points.back().point_in_map - corner).norm(), 0.5);
  EXPECT_GT(plan.paths[0].duration_s(), told.duration_s());

  search.problem.members[1].goal.reset();
  search.problem.members[0].goal = Vector2d{3, 9};
  const JointPlan robots_goal = plan_with(search.problem, 50, 1);
  EXPECT_TRUE(std::isfinite(robots_goal.goal_reached_s[0]));
  EXPECT_TRUE(std::isinf(robots_goal.goal_reached_s[1]));
}

TEST(TandemPlanner, T18AMemberThatCanGoNowhereWaitsAndTheOtherGoesOn) {
  Searcher stuck = test_robot();
  stuck.radius_m = 1.9;  // fits hardly anywhere
  SearchCase search = hall({test_person(), stuck});
  const JointPlan plan = plan_with(search.problem, 10, 1);

  EXPECT_GT(plan.paths[0].duration_s(), 30.0);
}

TEST(TandemPlanner, T19WithoutAnyRolloutThereIsAPlan) {
  SearchCase search = hall({test_robot(), test_person()});
  const JointPlan plan = plan_with(search.problem, 0, 1);

  EXPECT_GT(plan.paths[0].duration_s(), 30.0);
  EXPECT_GT(plan.forecast.probability_found, 0.5);
}

TEST(TandemPlanner, T20MoreRolloutsNeverGiveAWorsePlan) {
  SearchCase search = hall({test_robot(), test_person()});
  TandemPlanner planner({});
  planner.begin(search.problem, Rng{3});
  double last_s = planner.best().value_s;
  for (int i = 0; i < 20; ++i) {
    planner.run(5, {});
    EXPECT_LE(planner.best().value_s, last_s + 1e-9);
    last_s = planner.best().value_s;
  }
}

TEST(TandemPlanner, T20EqualSeedAndRolloutsGiveTheSamePlanBitForBitHoweverTheyAreCut) {
  SearchCase search = hall({test_robot(), test_person()});
  const JointPlan a = plan_with(search.problem, 60, 9);
  TandemPlanner pieces({});
  pieces.begin(search.problem, Rng{9});
  for (int i = 0; i < 6; ++i) pieces.run(10, {});
  const JointPlan b = pieces.best();

  EXPECT_EQ(a.forecast.expected_time_s, b.forecast.expected_time_s);
  for (std::size_t m = 0; m < 2; ++m) {
    ASSERT_EQ(a.paths[m].points.size(), b.paths[m].points.size());
    for (std::size_t i = 0; i < a.paths[m].points.size(); ++i) {
      EXPECT_EQ(a.paths[m].points[i].time_s, b.paths[m].points[i].time_s);
      EXPECT_EQ(a.paths[m].points[i].point_in_map, b.paths[m].points[i].point_in_map);
    }
  }
}

TEST(TandemPlanner, T20TheOrderOfMembersDoesNotMatterToTheValueOfAPlan) {
  SearchCase search = hall({test_robot(), test_person()});
  const JointPlan plan = plan_with(search.problem, 5, 1);
  SearchProblem swapped = search.problem;
  std::swap(swapped.members[0], swapped.members[1]);

  EXPECT_NEAR(evaluated(swapped, {plan.paths[1], plan.paths[0]}).value_s, plan.value_s, 1e-9);
}

TEST(TandemPlanner, TheFirstPlanIsNeverWorseThanAnyOfItsSeedsOn200Worlds) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Rng rng{seed};
    std::vector<std::string> drawing(14, "#" + std::string(18, '.') + "#");
    drawing.front() = drawing.back() = std::string(20, '#');
    for (int column = 0; column < 8; ++column) drawing[1 + rng.index(12)][5 + rng.index(14)] = '#';
    SearchCase search(room(drawing), {1.5, 1.5}, {test_robot(), test_person()}, 2.0);
    for (double& mass : search.problem.masses.front()) mass *= rng.uniform();
    search.problem.horizon_s = 60.0;
    TandemPlanner tandem({});
    search.problem.current = plan_with(tandem, search.problem, 2, seed).paths;
    const double running_s = evaluated(search.problem, search.problem.current).value_s;
    const double first_s = plan_with(tandem, search.problem, 0, seed).value_s;
    for (const char* name : {"tandem:seeds=0,warm_start=0", "tandem:seeds=0,warm_start=0,exponent=1", "lawnmower"}) {
      const auto peer = make_planner(name);
      const double peer_s = plan_with(*peer, search.problem, 0, seed).value_s;
      EXPECT_LE(first_s, peer_s * (1.0 + kSinglePrecision)) << name << " on world " << seed;
    }
    EXPECT_LE(first_s, running_s * (1.0 + kSinglePrecision)) << "world " << seed;
  }
}

TEST(TandemPlanner, SplitsTheHallBetweenTheTwo) {
  SearchCase search = hall({test_robot(), test_person()});
  SearchCase alone = hall({test_person()});

  EXPECT_LT(plan_with(search.problem, 100, 1).forecast.expected_time_s,
            0.85 * plan_with(alone.problem, 100, 1).forecast.expected_time_s);
}

TEST(TandemPlanner, ARejectedPlanIsNotProposedAgain) {
  SearchCase search = hall({test_robot(), test_person()});
  for (int i = 0; i < 3; ++i) {
    const JointPlan plan = plan_with(search.problem, 100, 1);
    for (const auto& other : search.problem.rejected) EXPECT_FALSE(is_like(plan.paths, other)) << "after " << i;
    search.problem.rejected.push_back(plan.paths);
  }
}

TEST(TandemPlanner, OnASmallTreeRolloutsFindWhatExhaustiveSearchFinds) {
  Searcher agent = test_person();
  agent.view_max_m = 1.0;
  SearchCase search(empty_room(9, 2), {4.0, 1.5}, {agent}, 1.2);
  Rng rng{4};
  for (double& mass : search.problem.masses.front()) mass = rng.uniform() < 0.2 ? rng.uniform() : 0.0;
  search.problem.horizon_s = 15.0;
  const PreparedProblem prepared{search.problem};
  const PreparedProblem::Member& member = prepared.members().front();
  double best_s = 1e9;
  // All sequences of up to four lookouts that last beyond the horizon.
  const std::function<void(std::vector<int>, double)> extend = [&](const std::vector<int>& places, double time_s) {
    if (time_s >= search.problem.horizon_s || places.size() == 4) {
      best_s = std::min(best_s, prepared.plan({places}).value_s);
      return;
    }
    for (int next = 0; next < member.actions->lookouts(); ++next) {
      const int from = places.empty() ? member.start : places.back();
      const Leg& leg = member.actions->leg(from, next);
      if (next == from || !leg.possible()) continue;
      auto longer = places;
      longer.push_back(next);
      extend(longer, time_s + leg.duration_s);
    }
  };
  extend({}, 0.0);

  TandemOptions options;
  options.tree.eligible = 20;
  TandemPlanner planner(options);
  EXPECT_LE(plan_with(planner, search.problem, 5000, 1).value_s, best_s + 1e-9);
}

}  // namespace
}  // namespace tandem
