#include "services/planner/core/baselines/lawnmower_planner.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/search_corridor.hpp"

namespace tandem {
namespace {

TEST(LawnmowerPlanner, EveryOtherLaneIsMownBackwards) {
  // Two lanes of 1 m along x.
  const std::vector<Eigen::Vector2d> points{{0, 0}, {1, 0}, {2, 0}, {0, 1.5}, {1, 1.5}, {2, 1.5}};
  EXPECT_EQ(mowing_order(points, 1.0), (std::vector<int>{0, 1, 2, 5, 4, 3}));
  EXPECT_TRUE(mowing_order({}, 1.0).empty());
}

TEST(LawnmowerPlanner, LanesAreNotCutAnewUnderWay) {
  EXPECT_FALSE(LawnmowerPlanner().replans_under_way());
}

TEST(LawnmowerPlanner, EachMowsItsOwnPiece) {
  SearchCase search = corridor(2);
  LawnmowerPlanner planner;
  const JointPlan plan = plan_with(planner, search.problem, 0, 1);
  // Equal speeds: the corridor from 0.5 m to 12.5 m is cut at 6.5 m.
  const auto extremes = [](const TimedPath& path) {
    return std::ranges::minmax(path.points, {}, [](const TimedPoint& point) { return point.point_in_map.x(); });
  };
  const bool first_is_left = extremes(plan.paths[0]).min.point_in_map.x() < 2.0;
  const TimedPath& left = plan.paths[first_is_left ? 0 : 1];
  const TimedPath& right = plan.paths[first_is_left ? 1 : 0];
  EXPECT_LT(extremes(left).min.point_in_map.x(), 2.0);
  EXPECT_LT(extremes(left).max.point_in_map.x(), 7.5);
  EXPECT_GT(extremes(right).max.point_in_map.x(), 11.0);
  EXPECT_GT(plan.forecast.probability_found, 0.95);
}

}  // namespace
}  // namespace tandem
