#include "services/planner/core/motion/road_graph.hpp"

#include <gtest/gtest.h>

#include <cmath>

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
  const auto nodes = corridor.roads.nodes(0, 9);
  EXPECT_EQ(nodes.front(), corridor.roads.node(0));
  EXPECT_EQ(nodes.back(), corridor.roads.node(9));
}

TEST(RoadGraph, ReachesAddedPlacesAndForgetsThem) {
  Corridor corridor;
  const int start = corridor.roads.add_place(corridor.node(2.3));
  const int goal = corridor.roads.add_place(corridor.node(16.3));
  EXPECT_NEAR(corridor.roads.cost_m(start, goal), 14.0, 2.5);
  const auto nodes = corridor.roads.nodes(start, goal);
  EXPECT_EQ(nodes.front(), corridor.roads.node(start));
  EXPECT_EQ(nodes.back(), corridor.roads.node(goal));
  corridor.roads.forget_added_places();
  EXPECT_EQ(corridor.roads.add_place(corridor.node(5.0)), start);
}

TEST(RoadGraph, WhereNoWayLeadsThereIsNone) {
  const OccupancyGrid map = room({"#########", "#...#...#", "#...#...#", "#...#...#", "#########"});
  const MotionMap motion(map, {});
  RoadGraph roads(motion, {*motion.nearest_node({1.2, 1.2}, 0.5), *motion.nearest_node({3.3, 1.2}, 0.5)}, 2);
  EXPECT_TRUE(std::isinf(roads.cost_m(0, 1)));
  EXPECT_TRUE(roads.nodes(0, 1).empty());
}

}  // namespace
}  // namespace tandem
