#include "services/planner/core/team/joint_tree.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

struct Hall {
  SearchCase search{empty_room(16, 10), {3, 3}, {test_robot(), test_person()}};
  PreparedProblem prepared{search.problem};
  TeamGround ground = team_ground(prepared);
  RouteValue value{ground};
};

TEST(JointTree, ARolloutIsWorthWhatItsRoutesAre) {
  Hall hall;
  JointTree tree(hall.ground, hall.value, {}, {});
  Rng rng{1};
  for (int i = 0; i < 20; ++i) {
    const double value_s = tree.rollout(rng);
    EXPECT_DOUBLE_EQ(value_s, hall.value.value_s(tree.routes()));
  }
  EXPECT_GT(tree.size(), 10U);
}

TEST(JointTree, ComesBackToWhatItRemembersAsGood) {
  Hall hall;
  JointTree tree(hall.ground, hall.value, {}, {});
  Rng rng{2};
  for (int i = 0; i < 5; ++i) tree.rollout(rng);
  const Routes routes{{4, 5, 6}, {1, 2, 3}};
  tree.remember(routes, 1.0);  // far better than anything there is
  int first_moves_kept = 0;
  for (int i = 0; i < 60; ++i) {
    tree.rollout(rng);
    if (tree.routes()[0].front() == 4 && tree.routes()[1].front() == 1) ++first_moves_kept;
  }
  EXPECT_GT(first_moves_kept, 10);  // by chance about one
}

}  // namespace
}  // namespace tandem
