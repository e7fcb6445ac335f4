#include "services/planner/core/paper/action_tree.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/services/planner/support/action_trees.hpp"
#include "tests/services/planner/support/room.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

TEST(ActionTree, EachActionKnowsTheMostThatCanBeHadBelowIt) {
  // 1 shows cell 0 (0.2), below it 2 shows cell 1 (0.5) and 3 shows cell 0 again.
  ActionTree tree = hand_tree({{0, 1.0, 0}, {1, 1.0, 1}, {1, 1.0, 0}, {0, 1.0, 2}});
  prune(tree, {0.2, 0.5, 0.3}, {.eligible = 4, .travel_cost_per_s = 0.0});
  EXPECT_DOUBLE_EQ(tree[0].bound, 0.7);
  EXPECT_DOUBLE_EQ(tree[1].gain, 0.2);
  EXPECT_DOUBLE_EQ(tree[1].bound, 0.5);
  EXPECT_DOUBLE_EQ(tree[3].gain, 0.0);  // a pool pays once
  EXPECT_EQ(tree[0].eligible, (std::vector<int>{1, 4}));
  EXPECT_NEAR(tree[0].selection[0], 0.7, 1e-12);  // 0.7 against 0.3
  EXPECT_NEAR(tree[0].selection[1], 0.3, 1e-12);
}

TEST(ActionTree, OnlyTheMostPromisingChildrenStayEligible) {
  ActionTree tree = hand_tree({{0, 1.0, 0}, {0, 1.0, 1}, {0, 1.0, 2}});
  prune(tree, {0.2, 0.5, 0.3}, {.eligible = 2, .travel_cost_per_s = 0.0});
  EXPECT_EQ(tree[0].eligible, (std::vector<int>{2, 3}));
}

TEST(ActionTree, AChildThatPromisesNothingCanStillBeSelected) {
  ActionTree tree = hand_tree({{0, 1.0, 0}, {0, 1.0}});
  prune(tree, {1.0}, {.eligible = 4, .travel_cost_per_s = 0.0});
  EXPECT_GT(tree[0].selection[1], 0.0);
}

TEST(ActionTree, TravelCostsWhatASecondCostsInPartsOfTheMassLeft) {
  ActionTree tree = hand_tree({{0, 4.0, 0}, {0, 1.0, 1}});
  prune(tree, {0.4, 0.4}, {.eligible = 4, .travel_cost_per_s = 0.1});
  EXPECT_NEAR(tree[1].gain, 0.4 - 4.0 * 0.1 * 0.8, 1e-12);
  EXPECT_NEAR(tree[2].gain, 0.4 - 1.0 * 0.1 * 0.8, 1e-12);
  EXPECT_EQ(tree[0].eligible, (std::vector<int>{2, 1}));
}

TEST(ActionTree, MovementsTakeTheirTimeAndShowWhatIsSeenOnTheWay) {
  const OccupancyGrid map = empty_room(10, 4);
  const SearchArea area(map, {.start_in_map = {1.5, 1.5}, .outline_in_map = {}});
  Searcher searcher;
  searcher.speed_mps = 0.5;
  searcher.view_max_m = 2.0;
  searcher.detection_rate_per_s = std::numeric_limits<double>::infinity();
  Observability sight(map, area, 2.0);
  ViewTable views(sight, searcher);
  const std::vector<TreeNode> nodes{{{1.5, 1.5}, -1, 0.0}, {{3.5, 1.5}, 0, 2.0}, {{3.5, 3.0}, 1, 3.5}};
  const ActionTree tree = action_tree(nodes, 0.0, 100.0, views);

  ASSERT_EQ(tree.size(), 3U);
  EXPECT_EQ(tree[1].duration_ms, 4000);
  EXPECT_DOUBLE_EQ(tree[2].start_s, 4.0);
  EXPECT_EQ(tree[2].duration_ms, 3000);
  EXPECT_DOUBLE_EQ(path_to(tree, 2).duration_s(), 7.0);
  const int ahead = *area.cell_at(Vector2d{4.75, 1.75});
  EXPECT_TRUE(std::ranges::any_of(tree[1].draws, [&](const Draw& draw) { return draw.cell == ahead; }));
  const int behind_sight = *area.cell_at(Vector2d{8.75, 1.75});
  EXPECT_FALSE(std::ranges::any_of(tree[1].draws, [&](const Draw& draw) { return draw.cell == behind_sight; }));

  EXPECT_EQ(action_tree(nodes, 0.0, 6.0, views).size(), 2U);  // the second movement would end after 7 s
}

TEST(ActionTree, OneWhoDoesNotSeeAllAroundTurnsAtCorners) {
  const OccupancyGrid map = empty_room(10, 4);
  const SearchArea area(map, {.start_in_map = {1.5, 1.5}, .outline_in_map = {}});
  Searcher searcher;
  searcher.speed_mps = 0.5;
  searcher.turn_rate_radps = std::numbers::pi / 4.0;
  searcher.field_of_view_rad = std::numbers::pi / 2.0;
  Observability sight(map, area, 2.0);
  ViewTable views(sight, searcher);
  const std::vector<TreeNode> nodes{{{1.5, 1.5}, -1, 0.0}, {{3.5, 1.5}, 0, 2.0}, {{3.5, 2.5}, 1, 3.0}};
  const ActionTree tree = action_tree(nodes, 0.0, 100.0, views);
  EXPECT_EQ(tree[1].duration_ms, 4000);
  EXPECT_EQ(tree[2].duration_ms, 4000);  // 2 s for a right angle, 2 s for 1 m
}

}  // namespace
}  // namespace tandem
