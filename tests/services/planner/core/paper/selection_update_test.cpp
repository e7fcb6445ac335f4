#include "services/planner/core/paper/selection_update.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/services/planner/support/action_trees.hpp"

namespace tandem {
namespace {

TEST(SelectionUpdate, T12SoundlyTheReductionIsLessTheFartherFromTheLastAction) {
  const SelectionUpdate sound{0.5, 0.8, Reading::Sound};
  EXPECT_DOUBLE_EQ(reduction_factor(sound, 2), 0.68);  // the first action of three
  EXPECT_DOUBLE_EQ(reduction_factor(sound, 1), 0.60);
  EXPECT_DOUBLE_EQ(reduction_factor(sound, 0), 0.50);  // the last
}

TEST(SelectionUpdate, T12AsPrintedItIsMoreTheFartherFromTheLastAction) {
  const SelectionUpdate printed{0.5, 0.8, Reading::Printed};
  EXPECT_DOUBLE_EQ(reduction_factor(printed, 2), 0.32);
  EXPECT_DOUBLE_EQ(reduction_factor(printed, 1), 0.40);
  EXPECT_DOUBLE_EQ(reduction_factor(printed, 0), 0.50);
}

TEST(SelectionUpdate, WhatOneActionLosesItsSiblingsGain) {
  ActionTree tree = hand_tree({{0}, {0}, {1}, {1}});  // 1 and 2 below the root, 3 and 4 below 1
  reduce_selection(tree, 3, {0.5, 0.8, Reading::Sound});
  EXPECT_NEAR(tree[1].selection[0], 0.25 / 0.75, 1e-12);  // 3: half of a half, normalised with its sibling's half
  EXPECT_NEAR(tree[1].selection[1], 0.50 / 0.75, 1e-12);
  EXPECT_NEAR(tree[0].selection[0], 0.30 / 0.80, 1e-12);  // 1: a half times 0.6
  EXPECT_NEAR(tree[0].selection[1], 0.50 / 0.80, 1e-12);
}

TEST(SelectionUpdate, HoweverOftenReducedAnActionStaysPossibleAndTheSumIsOne) {
  ActionTree tree = hand_tree({{0}, {0}});
  for (int i = 0; i < 1000; ++i) {
    reduce_selection(tree, 1, {0.3, 0.8, Reading::Printed});
    EXPECT_NEAR(std::accumulate(tree[0].selection.begin(), tree[0].selection.end(), 0.0), 1.0, 1e-12);
  }
  EXPECT_GT(tree[0].selection[0], 0.9 * kLeastSelection);
}

}  // namespace
}  // namespace tandem
