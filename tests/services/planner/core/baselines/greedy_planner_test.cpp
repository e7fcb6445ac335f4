#include "services/planner/core/baselines/greedy_planner.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/search_corridor.hpp"

namespace tandem {
namespace {

TEST(GreedyPlanner, TheExponentWeighsTimeAgainstGain) {
  const std::vector<WalkOption> options{{7, 0.2, 2.0}, {8, 0.8, 5.0}, {9, 0.0, 0.5}};
  EXPECT_EQ(greediest(options, 1.0), 8);  // 0.1 against 0.16 per second
  EXPECT_EQ(greediest(options, 2.0), 7);  // 0.05 against 0.032
  EXPECT_EQ(greediest({}, 1.0), -1);
}

TEST(GreedyPlanner, T16TwoAgentsSplit) {
  SearchCase search = corridor(2);
  place_mass(search, 2.75, 0.2, 10.25, 0.8);
  GreedyPlanner greedy({});
  const JointPlan plan = plan_with(greedy, search.problem, 0, 1);
  EXPECT_LT(plan.forecast.expected_time_s, 0.8 * 5.5 + 0.2 * 2.0);
  EXPECT_DOUBLE_EQ(plan.forecast.probability_found, 1.0);
}

TEST(GreedyPlanner, WithoutKnowingOfTheOtherBothGoTheSameWay) {
  SearchCase search = corridor(2);
  place_mass(search, 2.75, 0.2, 10.25, 0.8);
  GreedyPlanner no_intent({.exponent = 1.0, .most_options = 40, .mates = Mates::NoIntent});
  const JointPlan plan = plan_with(no_intent, search.problem, 0, 1);
  EXPECT_EQ(plan.paths[0].points.back().point_in_map, plan.paths[1].points.back().point_in_map);
}

TEST(GreedyPlanner, OnlyIndependentMembersKeepTheirLooksToThemselves) {
  EXPECT_TRUE(GreedyPlanner({}).shares_looks());
  EXPECT_TRUE(GreedyPlanner({.exponent = 1.0, .most_options = 40, .mates = Mates::NoIntent}).shares_looks());
  EXPECT_FALSE(GreedyPlanner({.exponent = 1.0, .most_options = 40, .mates = Mates::Independent}).shares_looks());
}

TEST(GreedyPlanner, SeesAllOfARoom) {
  SearchCase search = corridor(1);
  GreedyPlanner greedy({});
  EXPECT_GT(plan_with(greedy, search.problem, 0, 1).forecast.probability_found, 0.95);
}

TEST(GreedyPlanner, AFixedGoalIsWhereThePlanEnds) {
  SearchCase search = corridor(2);
  search.problem.members[0].goal = Eigen::Vector2d{1.25, 1.0};
  GreedyPlanner greedy({});
  const JointPlan plan = plan_with(greedy, search.problem, 0, 1);
  EXPECT_LE((plan.paths[0].points.back().point_in_map - Eigen::Vector2d{1.25, 1.0}).norm(), 0.5);
}

}  // namespace
}  // namespace tandem
