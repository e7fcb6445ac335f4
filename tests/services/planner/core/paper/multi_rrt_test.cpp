#include "services/planner/core/paper/multi_rrt.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/services/planner/support/room.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

MotionMap two_rooms() {
  MotionOptions options;
  options.radius_m = 0.25;
  return {room({"###########", "#....#....#", "#....#....#", "#.........#", "###########"}, 1.0), options};
}

bool is_in_order(const std::vector<TreeNode>& nodes) {
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    if (nodes[i].parent < 0 || nodes[i].parent >= static_cast<int>(i)) return false;
  }
  return true;
}

TEST(MultiRrt, AGoalsTreeIsJoinedSoThatASequenceLeadsToTheGoal) {
  const MotionMap motion = two_rooms();
  const Vector2d goal{9.5, 3.5};
  MultiRrtOptions options;
  options.nodes = 150;
  options.goal_nodes = 30;
  Rng rng{3};
  const auto nodes = multi_rrt(motion, 0.25, {1.5, 3.5}, {goal}, options, rng);

  EXPECT_TRUE(is_in_order(nodes));
  EXPECT_GT(nodes.size(), 150U);
  const auto at_goal = std::ranges::find_if(nodes, [&](const TreeNode& node) { return node.point_in_map == goal; });
  ASSERT_NE(at_goal, nodes.end());
  EXPECT_LT(at_goal->cost_m, 10.0);  // 8.2 m past the end of the wall
}

TEST(MultiRrt, WithoutGoalTreesThereIsOneTree) {
  const MotionMap motion = two_rooms();
  MultiRrtOptions options;
  options.nodes = 100;
  options.goal_trees = 0;
  Rng rng{3};
  EXPECT_EQ(multi_rrt(motion, 0.25, {1.5, 3.5}, {{9.5, 3.5}}, options, rng).size(), 100U);
}

TEST(MultiRrt, EverySequenceToAFixedGoalEndsThere) {
  const MotionMap motion = two_rooms();
  const Vector2d goal{9.5, 3.5};
  MultiRrtOptions options;
  options.nodes = 200;
  Rng rng{3};
  const auto nodes = multi_rrt_to(motion, 0.25, {1.5, 3.5}, goal, options, rng);

  ASSERT_TRUE(is_in_order(nodes));
  std::vector<bool> has_child(nodes.size(), false);
  for (const TreeNode& node : nodes) {
    if (node.parent >= 0) has_child[static_cast<std::size_t>(node.parent)] = true;
  }
  int ways = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (has_child[i]) continue;
    ++ways;
    EXPECT_EQ(nodes[i].point_in_map, goal);
  }
  EXPECT_GT(ways, 1);
}

TEST(MultiRrt, AGoalThatCannotBeReachedLeavesTheRoot) {
  MotionOptions body;
  body.radius_m = 0.25;
  const MotionMap motion(room({"#######", "#..#..#", "#..#..#", "#######"}, 1.0), body);
  Rng rng{3};
  EXPECT_EQ(multi_rrt_to(motion, 0.25, {1.5, 1.5}, {5.5, 1.5}, {}, rng).size(), 1U);
}

}  // namespace
}  // namespace tandem
