#include "services/planner/core/team/team_problem.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/services/planner/support/search_world.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

TimedPath straight(const Vector2d& from, const Vector2d& to) {
  return {{{0.0, from}, {30.0, to}}};
}

TEST(IsLike, APathNearTheRejectedOneOnAverageIsLikeIt) {
  const std::vector<TimedPath> rejected{straight({0, 0}, {15, 0})};

  EXPECT_TRUE(is_like({straight({0, 1}, {15, 1})}, rejected));
  EXPECT_FALSE(is_like({straight({0, 3}, {15, 3})}, rejected));
  EXPECT_FALSE(is_like({straight({0, 0}, {0, 15})}, rejected));
}

TEST(IsLike, OneMemberWhoGoesElsewhereMakesAnotherPlan) {
  const TimedPath ahead = straight({0, 0}, {15, 0});
  const TimedPath aside = straight({0, 0}, {0, 15});
  EXPECT_TRUE(is_like({ahead, ahead}, {ahead, ahead}));
  EXPECT_FALSE(is_like({ahead, aside}, {ahead, ahead}));
}

class TeamProblemTest : public testing::Test {
 protected:
  TeamProblemTest() { world_.add(test_person(), {3, 3}); }

  /// The two lookouts nearest to the start.
  std::vector<std::vector<int>> short_round() {
    const auto& nearest = world_.sets[0]->nearest_lookouts(world_.problem.members[0].start);
    return {{nearest.at(0), nearest.at(1)}};
  }

  SearchWorld world_{empty_room(16, 10), {3, 3}};
  SearchForecaster forecaster_{0.5, 120.0};
};

TEST_F(TeamProblemTest, WaitingFindsNothing) {
  const JointPlan plan = evaluated(world_.problem, {{}}, forecaster_);
  EXPECT_DOUBLE_EQ(plan.forecast.probability_found, 0.0);
}

TEST_F(TeamProblemTest, GoingSomewhereIsBetterThanWaiting) {
  const JointPlan waiting = evaluated(world_.problem, {{}}, forecaster_);
  const JointPlan going = evaluated(world_.problem, short_round(), forecaster_);
  EXPECT_GT(going.forecast.probability_found, 0.0);
  EXPECT_LT(going.value_s, waiting.value_s);
}

TEST_F(TeamProblemTest, TheChosenPlanGetsPathsAndAFallingSurvival) {
  JointPlan plan = evaluated(world_.problem, short_round(), forecaster_);
  add_paths(world_.problem, forecaster_, plan);

  EXPECT_EQ(plan.members[0].path.points.front().point_in_map, world_.sets[0]->place(world_.problem.members[0].start));
  EXPECT_GT(plan.members[0].path.duration_s(), 0.0);
  EXPECT_TRUE(std::is_sorted(plan.survival.rbegin(), plan.survival.rend()));
  EXPECT_NEAR(1.0 - plan.survival.back(), plan.forecast.probability_found, 1e-9);
}

TEST_F(TeamProblemTest, ARejectedPlanIsWorthLessThanAnyOther) {
  JointPlan plan = evaluated(world_.problem, short_round(), forecaster_);
  add_paths(world_.problem, forecaster_, plan);
  world_.problem.taboo.push_back({plan.members[0].path});

  EXPECT_GT(evaluated(world_.problem, short_round(), forecaster_).value_s, plan.value_s + 1000.0);
}

}  // namespace
}  // namespace tandem
