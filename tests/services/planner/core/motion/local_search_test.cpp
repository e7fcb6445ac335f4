#include "services/planner/core/motion/local_search.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/room.hpp"

namespace tandem {
namespace {

TEST(LocalSearch, ReachesNodesInTheOrderOfTheirCostAndAsCheaplyAsTheWholeSearch) {
  const OccupancyGrid map = room({"############", "#....##....#", "#....##....#", "#....##....#", "#..........#",
                                  "#..........#", "#..........#", "############"});
  const MotionMap motion(map, {});
  const int from = *motion.nearest_node({1.5, 3}, 0.5);
  const ShortestPaths all = motion.shortest_paths(from);
  LocalSearch search(motion);
  double last_m = 0.0;
  int reached = 0;
  search.run(from, [&](int node, double cost_m) {
    EXPECT_GE(cost_m, last_m);
    EXPECT_FLOAT_EQ(static_cast<float>(cost_m), all.cost_m[static_cast<std::size_t>(node)]);
    last_m = cost_m;
    ++reached;
    return true;
  });
  EXPECT_EQ(reached, motion.size());
}

TEST(LocalSearch, StopsWhenItIsToldAndKnowsTheWayThere) {
  const OccupancyGrid map = empty_room(10, 10);
  const MotionMap motion(map, {});
  const int from = *motion.nearest_node({2, 2}, 0.5);
  const int to = *motion.nearest_node({4, 2}, 0.5);
  LocalSearch search(motion);
  int reached = 0;
  search.run(from, [&](int node, double) {
    ++reached;
    return node != to;
  });
  EXPECT_LT(reached, motion.size() / 2);
  const auto nodes = search.nodes_to(to);
  EXPECT_EQ(nodes.front(), from);
  EXPECT_EQ(nodes.back(), to);
  EXPECT_EQ(nodes.size(), 11U);  // 2 m in steps of 0.2 m
}

}  // namespace
}  // namespace tandem
