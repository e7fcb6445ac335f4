#include "services/planner/core/team/team_planner.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/services/planner/support/search_world.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

/// A hall of 16 m x 10 m with a wall that juts in, for two.
SearchWorld hall() {
  std::vector<std::string> drawing(22, "#" + std::string(32, '.') + "#");
  drawing.front() = drawing.back() = std::string(34, '#');
  for (std::size_t row = 1; row < 13; ++row) drawing[row][16] = '#';
  return {room(drawing), {3, 3}};
}

JointPlan plan_with(const TeamProblem& problem, int rollouts, std::uint64_t seed) {
  TeamPlanner planner(problem, {}, Rng{seed});
  planner.run(rollouts);
  return planner.best();
}

/// All mass in small places near two points of a corridor.
void place_mass(SearchWorld& world, const Vector2d& a, double mass_a, const Vector2d& b, double mass_b) {
  std::fill(world.problem.mass.begin(), world.problem.mass.end(), 0.0);
  world.problem.mass[static_cast<std::size_t>(*world.area.cell_at(a))] = mass_a;
  world.problem.mass[static_cast<std::size_t>(*world.area.cell_at(b))] = mass_b;
}

Searcher short_sighted() {
  Searcher agent = test_person();
  agent.view_max_m = 0.6;
  agent.detection_rate_per_s = 100.0;
  agent.speed_mps = 1.0;
  return agent;
}

TEST(TeamPlanner, T15OneAgentGoesToTheLikelyRoomFirstThoughItIsFarther) {
  SearchWorld world(empty_room(12, 1), {4.75, 1.0});
  world.add(short_sighted(), {4.75, 1.0}, 0.7);
  place_mass(world, {2.75, 1.0}, 0.2, {10.25, 1.0}, 0.8);  // 2 m and 5.5 m away, seen from 0.6 m
  world.problem.horizon_steps = 60;
  const JointPlan plan = plan_with(world.problem, 200, 1);

  const double likely_first_s = 0.8 * 4.9 + 0.2 * (4.9 + 6.3);
  EXPECT_NEAR(plan.forecast.expected_time_s, likely_first_s, 1.0);
  EXPECT_GT(pose_at(plan.members[0].path, 4.0).x, 7.0);
}

TEST(TeamPlanner, T16TwoAgentsSplit) {
  SearchWorld world(empty_room(12, 1), {4.75, 1.0});
  world.add(short_sighted(), {4.75, 1.0}, 0.7);
  world.add(short_sighted(), {4.75, 1.0}, 0.7);
  place_mass(world, {2.75, 1.0}, 0.2, {10.25, 1.0}, 0.8);
  world.problem.horizon_steps = 60;
  const JointPlan plan = plan_with(world.problem, 200, 1);

  EXPECT_NEAR(plan.forecast.expected_time_s, 0.8 * 4.9 + 0.2 * 1.4, 1.0);
}

TEST(TeamPlanner, T17AFixedGoalEndsItsMembersPathAndTheOtherSearchesOn) {
  SearchWorld world = hall();
  ActionSet& robot = world.add(test_robot(), {3, 3});
  ActionSet& person = world.add(test_person(), {3, 3});
  const Vector2d corner{15.75, 9.75};
  world.problem.members[1].goal = person.add_place(corner, 2.0);
  ASSERT_TRUE(world.problem.members[1].goal);
  const JointPlan plan = plan_with(world.problem, 50, 1);

  EXPECT_LE((plan.members[1].path.points.back().point_in_map - corner).norm(), 0.5);
  EXPECT_GT(plan.members[0].path.duration_s(), plan.members[1].path.duration_s());

  world.problem.members[1].goal.reset();
  world.problem.members[0].goal = robot.add_place({3, 9}, 1.0);
  const JointPlan robots_goal = plan_with(world.problem, 50, 1);
  EXPECT_LE((robots_goal.members[0].path.points.back().point_in_map - Vector2d{3, 9}).norm(), 0.5);
}

TEST(TeamPlanner, T18AMemberThatCanGoNowhereWaitsAndTheOtherGoesOn) {
  SearchWorld world = hall();
  Searcher stuck = test_robot();
  stuck.radius_m = 1.9;  // fits hardly anywhere
  world.add(test_person(), {3, 3});
  world.add(stuck, {3, 3});
  const JointPlan plan = plan_with(world.problem, 10, 1);

  EXPECT_GT(plan.members[0].places.size(), 3U);
}

TEST(TeamPlanner, T19WithoutAnyRolloutThereIsAPlan) {
  SearchWorld world = hall();
  world.add(test_robot(), {3, 3});
  world.add(test_person(), {3, 3});
  const JointPlan plan = plan_with(world.problem, 0, 1);

  EXPECT_GT(plan.members[0].path.duration_s(), 30.0);
  EXPECT_GT(plan.forecast.probability_found, 0.5);
}

TEST(TeamPlanner, T20MoreRolloutsNeverGiveAWorsePlan) {
  SearchWorld world = hall();
  world.add(test_robot(), {3, 3});
  world.add(test_person(), {3, 3});
  TeamPlanner planner(world.problem, {}, Rng{3});
  double last_s = planner.best_value_s();
  for (int i = 0; i < 20; ++i) {
    planner.run(5);
    EXPECT_LE(planner.best_value_s(), last_s);
    last_s = planner.best_value_s();
  }
}

TEST(TeamPlanner, T20EqualSeedAndRolloutsGiveTheSamePlanBitForBitHoweverTheyAreCut) {
  SearchWorld world = hall();
  world.add(test_robot(), {3, 3});
  world.add(test_person(), {3, 3});
  TeamPlanner whole(world.problem, {}, Rng{9});
  whole.run(60);
  TeamPlanner pieces(world.problem, {}, Rng{9});
  for (int i = 0; i < 6; ++i) pieces.run(10);
  const JointPlan a = whole.best();
  const JointPlan b = pieces.best();

  EXPECT_EQ(a.forecast.expected_time_s, b.forecast.expected_time_s);
  for (std::size_t m = 0; m < 2; ++m) EXPECT_EQ(a.members[m].places, b.members[m].places);
}

TEST(TeamPlanner, T20TheOrderOfMembersDoesNotMatterToTheValueOfAPlan) {
  SearchWorld world = hall();
  world.add(test_robot(), {3, 3});
  world.add(test_person(), {3, 3});
  const JointPlan plan = plan_with(world.problem, 5, 1);
  TeamProblem swapped = world.problem;
  std::swap(swapped.members[0], swapped.members[1]);
  SearchForecaster forecaster(0.5, swapped.tail_s);

  const auto same = evaluated(swapped, {plan.members[1].places, plan.members[0].places}, forecaster);
  EXPECT_NEAR(same.value_s, plan.value_s, 1e-9);
}

TEST(TeamPlanner, SplitsTheHallBetweenTheTwo) {
  SearchWorld world = hall();
  world.add(test_robot(), {3, 3});
  world.add(test_person(), {3, 3});
  const JointPlan plan = plan_with(world.problem, 100, 1);
  SearchWorld alone = hall();
  alone.add(test_person(), {3, 3});
  const JointPlan single = plan_with(alone.problem, 100, 1);

  EXPECT_LT(plan.forecast.expected_time_s, 0.85 * single.forecast.expected_time_s);
}

TEST(TeamPlanner, ARejectedPlanIsNotProposedAgain) {
  SearchWorld world = hall();
  world.add(test_robot(), {3, 3});
  world.add(test_person(), {3, 3});
  std::vector<std::vector<TimedPath>> rejected;
  for (int i = 0; i < 3; ++i) {
    const JointPlan plan = plan_with(world.problem, 100, 1);
    const std::vector<TimedPath> paths{plan.members[0].path, plan.members[1].path};
    for (const auto& other : rejected) EXPECT_FALSE(is_like(paths, other)) << "after " << i;
    rejected.push_back(paths);
    world.problem.taboo = rejected;
  }
}

TEST(TeamPlanner, OnASmallTreeRolloutsFindWhatExhaustiveSearchFinds) {
  SearchWorld world(empty_room(9, 2), {1.5, 1.5});
  Searcher agent = test_person();
  agent.view_max_m = 1.0;
  ActionSet& actions = world.add(agent, {4.0, 1.5}, 1.2);
  Rng rng{4};
  for (double& mass : world.problem.mass) mass = rng.uniform() < 0.2 ? rng.uniform() : 0.0;
  world.problem.horizon_steps = 30;
  SearchForecaster forecaster(0.5, world.problem.tail_s);
  double best_s = 1e9;
  // All sequences of up to four lookouts that last beyond the horizon.
  const std::function<void(std::vector<int>, int)> extend = [&](const std::vector<int>& places, int steps) {
    if (steps >= world.problem.horizon_steps || places.size() == 4) {
      best_s = std::min(best_s, evaluated(world.problem, {places}, forecaster).value_s);
      return;
    }
    for (int next = 0; next < actions.lookouts(); ++next) {
      const int from = places.empty() ? world.problem.members[0].start : places.back();
      const Leg& leg = actions.leg(from, next);
      if (next == from || !leg.possible()) continue;
      auto longer = places;
      longer.push_back(next);
      extend(longer, steps + leg.steps());
    }
  };
  extend({}, 0);

  TeamPlannerOptions options;
  options.eligible = 20;
  TeamPlanner planner(world.problem, options, Rng{1});
  planner.run(5000);
  EXPECT_LE(planner.best_value_s(), best_s + 1e-9);
}

}  // namespace
}  // namespace tandem
