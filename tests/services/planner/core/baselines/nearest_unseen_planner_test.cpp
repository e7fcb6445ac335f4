#include "services/planner/core/baselines/nearest_unseen_planner.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/search_corridor.hpp"

namespace tandem {
namespace {

TEST(NearestUnseenPlanner, TheNearestComesFirstHoweverUnlikely) {
  SearchCase search = corridor(1);
  place_mass(search, 2.75, 0.2, 10.25, 0.8);
  NearestUnseenPlanner planner;
  const JointPlan plan = plan_with(planner, search.problem, 0, 1);
  EXPECT_LT(pose_at(plan.paths[0], 2.0).x, 4.0);
  EXPECT_DOUBLE_EQ(plan.forecast.probability_found, 1.0);
}

TEST(NearestUnseenPlanner, TwoDoNotGoToTheSamePlace) {
  SearchCase search = corridor(2);
  place_mass(search, 2.75, 0.2, 10.25, 0.8);
  NearestUnseenPlanner planner;
  const JointPlan plan = plan_with(planner, search.problem, 0, 1);
  EXPECT_LT(plan.paths[0].points.back().point_in_map.x(), 4.75);
  EXPECT_GT(plan.paths[1].points.back().point_in_map.x(), 4.75);
}

}  // namespace
}  // namespace tandem
