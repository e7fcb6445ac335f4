#include "services/planner/core/motion/road_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/services/planner/support/room.hpp"

namespace tandem {
namespace {

/// A corridor of 20 m with a lookout each 2 m, each joined to two others.
struct Corridor {
  OccupancyGrid map = empty_room(20, 2);
  MotionMap motion{map, {}};
  RoadGraph roads{motion, lookouts(), 2};
  [[nodiscard]] int node(double x) const { return *motion.nearest_node({x, 1.5}, 0.5); }
  [[nodiscard]] std::vector<int> lookouts() const {
    std::vector<int> nodes;
    for (int i = 0; i < 10; ++i) nodes.push_back(node(1.5 + 2.0 * i));
    return nodes;
  }
};

TEST(RoadGraph, JoinsAPlaceToItsNearestLookouts) {
  Corridor corridor;
  const auto& roads = corridor.roads.roads(4);
  ASSERT_EQ(roads.size(), 2U);
  EXPECT_EQ(roads[0].to + roads[1].to, 8);  // 3 and 5
  EXPECT_NEAR(roads[0].cost_m, 2.0, 0.05);
}

TEST(RoadGraph, ReachesFarLookoutsOverThoseInBetween) {
  Corridor corridor;
  EXPECT_NEAR(corridor.roads.cost_m(0, 9), 18.0, 0.3);
  const auto stops = corridor.roads.stops(0, 9);
  ASSERT_FALSE(stops.empty());
  EXPECT_EQ(stops.back(), 9);
  int from = 0;
  double way_m = 0.0;
  for (const int stop : stops) {
    const auto nodes = corridor.roads.nodes(from, stop);
    EXPECT_EQ(nodes.front(), corridor.roads.node(from));
    EXPECT_EQ(nodes.back(), corridor.roads.node(stop));
    way_m += corridor.roads.cost_m(from, stop);
    from = stop;
  }
  EXPECT_NEAR(way_m, corridor.roads.cost_m(0, 9), 1e-3);
}

TEST(RoadGraph, ExploresLookoutsTheNearestFirstUntilToldToStop) {
  Corridor corridor;
  std::vector<int> met;
  double last_m = 0.0;
  corridor.roads.explore(2, [&](int lookout, double cost_m) {
    EXPECT_GE(cost_m, last_m);
    last_m = cost_m;
    met.push_back(lookout);
    return met.size() < 5;
  });
  ASSERT_EQ(met.size(), 5U);
  EXPECT_NEAR(last_m, corridor.roads.cost_m(2, met.back()), 1e-3);
  EXPECT_EQ(std::ranges::count(met, 2), 0);
  EXPECT_EQ(met.back(), 5);  // 1 and 3, 0 and 4, then 5
}

TEST(RoadGraph, ReachesAddedPlacesAndForgetsThem) {
  Corridor corridor;
  const int start = corridor.roads.add_place(corridor.node(2.3));
  const int goal = corridor.roads.add_place(corridor.node(16.3));
  EXPECT_NEAR(corridor.roads.cost_m(start, goal), 14.0, 0.1);
  EXPECT_EQ(corridor.roads.stops(start, goal), std::vector<int>{goal});
  const auto nodes = corridor.roads.nodes(start, goal);
  EXPECT_EQ(nodes.front(), corridor.roads.node(start));
  EXPECT_EQ(nodes.back(), corridor.roads.node(goal));
  const auto stops = corridor.roads.stops(0, goal);
  ASSERT_GE(stops.size(), 2U);
  EXPECT_EQ(stops.back(), goal);
  EXPECT_EQ(corridor.roads.nodes(stops[stops.size() - 2], goal).back(), corridor.roads.node(goal));
  corridor.roads.forget_added_places();
  EXPECT_EQ(corridor.roads.add_place(corridor.node(5.0)), start);
}

TEST(RoadGraph, WhereNoWayLeadsThereIsNone) {
  const OccupancyGrid map = room({"#########", "#...#...#", "#...#...#", "#...#...#", "#########"});
  const MotionMap motion(map, {});
  RoadGraph roads(motion, {*motion.nearest_node({1.2, 1.2}, 0.5), *motion.nearest_node({3.3, 1.2}, 0.5)}, 2);
  EXPECT_TRUE(std::isinf(roads.cost_m(0, 1)));
  EXPECT_TRUE(roads.nodes(0, 1).empty());
  EXPECT_TRUE(roads.stops(0, 1).empty());
}

}  // namespace
}  // namespace tandem
