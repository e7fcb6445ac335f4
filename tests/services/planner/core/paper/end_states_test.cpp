#include "services/planner/core/paper/end_states.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/action_trees.hpp"

namespace tandem {
namespace {

TEST(EndStates, TheMostRewardingEndsComeFirstAndNotTwoOfThemTogether) {
  ActionTree tree = hand_tree({{0, 1.0}, {0, 2.0}, {0, 9.0}});  // ends 1 m, 2 m and 9 m away
  tree[1].gain = 0.5;
  tree[2].gain = 0.4;
  tree[3].gain = 0.1;
  EXPECT_EQ(rewarding_goals(tree, 8, 4.0), (std::vector<int>{1, 3}));
  EXPECT_EQ(rewarding_goals(tree, 2, 0.5), (std::vector<int>{1, 2}));
}

TEST(EndStates, WhereNothingCanBeDoneTheRootIsTheGoal) {
  EXPECT_EQ(rewarding_goals(hand_tree({}), 8, 4.0), (std::vector<int>{0}));
}

TEST(EndStates, TheBestGoalsOfAllAgentsAreCombinedFirst) {
  const auto candidates = end_state_candidates({{1, 2}, {5, 6}}, 64);
  ASSERT_EQ(candidates.size(), 4U);
  EXPECT_EQ(candidates[0], (std::array<int, kMostAgents>{1, 5}));
  EXPECT_EQ(candidates[1], (std::array<int, kMostAgents>{1, 6}));
  EXPECT_EQ(candidates[2], (std::array<int, kMostAgents>{2, 5}));
  EXPECT_EQ(candidates[3], (std::array<int, kMostAgents>{2, 6}));
}

TEST(EndStates, EightAgentsDoNotGiveMoreThanAskedFor) {
  const std::vector<std::vector<int>> goals(8, {1, 2, 3, 4, 5, 6, 7, 8});
  EXPECT_EQ(end_state_candidates(goals, 64).size(), 64U);
}

}  // namespace
}  // namespace tandem
