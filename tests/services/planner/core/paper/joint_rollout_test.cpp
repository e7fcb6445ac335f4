#include "services/planner/core/paper/joint_rollout.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/action_trees.hpp"

namespace tandem {
namespace {

constexpr std::int64_t kForEver = JointState::kForEver;
constexpr std::int64_t kNoTime[] = {0, 0};

std::size_t first(std::size_t /*agent*/, int /*action*/) {
  return 0;
}

TEST(JointRollout, T11AStateEndsWhenAnyActionEndsAndOnlyThenItsAgentBranches) {
  // A: 3 s, then 4 s; three choices after the first action. B: 5 s, then 2 s; two choices after the first.
  ActionTree a = hand_tree({{0, 3.0}, {1, 4.0}, {1, 4.0}, {1, 4.0}});
  ActionTree b = hand_tree({{0, 5.0}, {1, 2.0}, {1, 2.0}});
  const std::vector<ActionTree*> trees{&a, &b};

  const JointState at_3 = next_state(root_state(kNoTime), trees, first);
  EXPECT_EQ(at_3.time_ms, 3000);
  EXPECT_EQ(at_3.left_ms[0], 0);
  EXPECT_EQ(at_3.left_ms[1], 2000);
  EXPECT_EQ(branching(at_3, trees), 3U);

  const JointState at_5 = next_state(at_3, trees, first);
  EXPECT_EQ(at_5.time_ms, 5000);
  EXPECT_EQ(at_5.left_ms[0], 2000);
  EXPECT_EQ(at_5.left_ms[1], 0);
  EXPECT_EQ(branching(at_5, trees), 2U);

  const JointState at_7 = next_state(at_5, trees, first);
  EXPECT_EQ(at_7.time_ms, 7000);
  EXPECT_EQ(at_7.left_ms[0], 0);
  EXPECT_EQ(at_7.left_ms[1], 0);
  EXPECT_TRUE(is_final(at_7, trees, 60'000));
}

TEST(JointRollout, T11AtTheRootTheBranchingIsTheProductOfBoth) {
  ActionTree a = hand_tree({{0}, {0}, {0}});
  ActionTree b = hand_tree({{0}, {0}});
  const std::vector<ActionTree*> trees{&a, &b};
  EXPECT_EQ(branching(root_state(kNoTime), trees), 6U);
}

TEST(JointRollout, T18AnAgentWithoutActionsWaitsAndTheOtherGoesOn) {
  ActionTree a = hand_tree({});
  ActionTree b = hand_tree({{0, 1.0}, {1, 1.0}});
  const std::vector<ActionTree*> trees{&a, &b};
  const JointState state = next_state(root_state(kNoTime), trees, first);
  EXPECT_EQ(state.left_ms[0], kForEver);
  EXPECT_FALSE(is_final(state, trees, 60'000));
  Rng rng{1};
  const JointState last = rollout(root_state(kNoTime), trees, 60'000, rng);
  EXPECT_EQ(last.ongoing[1], 2);
  EXPECT_EQ(last.time_ms, 2000);
}

TEST(JointRollout, AnAgentUnderWayChoosesOnlyWhenItArrives) {
  ActionTree a = hand_tree({{0, 1.0}});
  ActionTree b = hand_tree({{0, 1.0}});
  const std::vector<ActionTree*> trees{&a, &b};
  const std::int64_t ready_ms[] = {0, 2500};
  const JointState state = next_state(root_state(ready_ms), trees, first);
  EXPECT_EQ(state.time_ms, 1000);
  EXPECT_EQ(state.ongoing[1], 0);
  EXPECT_EQ(state.left_ms[1], 1500);
}

TEST(JointRollout, TheHorizonEndsARollout) {
  ActionTree a = hand_tree({{0, 2.0}, {1, 2.0}, {2, 2.0}});
  const std::vector<ActionTree*> trees{&a};
  Rng rng{1};
  const std::int64_t ready_ms[] = {0};
  EXPECT_EQ(rollout(root_state(ready_ms), trees, 4000, rng).ongoing[0], 2);
}

TEST(JointRollout, ActionsAreDrawnAsOftenAsQSays) {
  ActionTree a = hand_tree({{0}, {0}});
  a[0].selection = {0.2, 0.8};
  const std::vector<ActionTree*> trees{&a};
  const std::int64_t ready_ms[] = {0};
  Rng rng{5};
  int second = 0;
  for (int i = 0; i < 10'000; ++i) second += rollout(root_state(ready_ms), trees, 60'000, rng).ongoing[0] == 2 ? 1 : 0;
  EXPECT_NEAR(second, 8000, 160);  // 4 standard deviations
}

}  // namespace
}  // namespace tandem
