#include "services/planner/core/paper/rrt_star.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/room.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

MotionOptions body() {
  MotionOptions options;
  options.radius_m = 0.25;
  return options;
}

/// A room of 10 m x 6 m, all of it within walls of 0.5 m.
MotionMap room_map() {
  return {empty_room(10, 6), body()};
}

RrtStar grown(const MotionMap& motion, const Vector2d& root, int tries, std::uint64_t seed) {
  RrtStar tree(motion, 0.25, 2.0, root);
  Rng rng{seed};
  for (int i = 0; i < tries; ++i) (void)tree.extend(random_place(motion, rng));
  return tree;
}

TEST(RrtStar, GoesTowardsASampleByAtMostAStep) {
  const MotionMap motion = room_map();
  RrtStar tree(motion, 0.25, 2.0, {1.5, 3.5});
  ASSERT_TRUE(tree.extend({6.5, 3.5}));
  ASSERT_TRUE(tree.extend({4.5, 3.5}));
  ASSERT_EQ(tree.nodes().size(), 3U);
  EXPECT_NEAR((tree.nodes()[1].point_in_map - Vector2d{3.5, 3.5}).norm(), 0.0, 1e-12);
  EXPECT_EQ(tree.nodes()[2].parent, 1);
  EXPECT_DOUBLE_EQ(tree.nodes()[2].cost_m, 3.0);
}

TEST(RrtStar, RewiresANodeWhenAShorterWayTurnsUp) {
  const MotionMap motion = room_map();
  RrtStar tree(motion, 0.25, 2.0, {1.5, 3.5});
  ASSERT_TRUE(tree.extend({1.5, 5.5}));  // 1: up
  ASSERT_TRUE(tree.extend({3.5, 5.5}));  // 2: then right, 4 m in all
  EXPECT_EQ(tree.nodes()[2].parent, 1);
  ASSERT_TRUE(tree.extend({2.5, 4.5}));  // 3: on the straight line between root and 2
  EXPECT_EQ(tree.nodes()[2].parent, 3);
  EXPECT_NEAR(tree.nodes()[2].cost_m, std::sqrt(8.0), 1e-12);
}

TEST(RrtStar, NoMovementGoesThroughAWall) {
  const OccupancyGrid map = room({"#########", "#...#...#", "#...#...#", "#.......#", "#########"}, 1.0);
  const MotionMap motion(map, body());
  const RrtStar tree = grown(motion, {1.5, 3.5}, 400, 1);
  EXPECT_GT(tree.nodes().size(), 50U);
  for (const TreeNode& node : tree.nodes()) {
    if (node.parent < 0) continue;
    const TreeNode& parent = tree.nodes()[static_cast<std::size_t>(node.parent)];
    EXPECT_LE((node.point_in_map - parent.point_in_map).norm(), 2.0 + 1e-9);
    EXPECT_GE(motion.clearance_m(parent.point_in_map, node.point_in_map), 0.23);
    EXPECT_NEAR(node.cost_m, parent.cost_m + (node.point_in_map - parent.point_in_map).norm(), 1e-9);
  }
}

TEST(RrtStar, InTheOpenItsWaysAreNearlyStraight) {
  const MotionMap motion = room_map();
  const Vector2d root{1.5, 1.5};
  const RrtStar tree = grown(motion, root, 1500, 2);
  double ratio = 0.0;
  for (const TreeNode& node : tree.nodes()) ratio = std::max(ratio, node.cost_m - (node.point_in_map - root).norm());
  EXPECT_LT(ratio, 0.6);
}

TEST(RrtStar, EqualSeedEqualTree) {
  const MotionMap motion = room_map();
  const RrtStar a = grown(motion, {5, 3}, 300, 7);
  const RrtStar b = grown(motion, {5, 3}, 300, 7);
  ASSERT_EQ(a.nodes().size(), b.nodes().size());
  for (std::size_t i = 0; i < a.nodes().size(); ++i) {
    EXPECT_EQ(a.nodes()[i].point_in_map, b.nodes()[i].point_in_map);
    EXPECT_EQ(a.nodes()[i].parent, b.nodes()[i].parent);
  }
}

}  // namespace
}  // namespace tandem
