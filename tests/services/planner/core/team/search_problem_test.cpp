#include "services/planner/core/team/search_problem.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/services/planner/support/search_case.hpp"

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

/// One who walks 4 m through an empty hall and sees 3 m far.
class SearchProblemTest : public testing::Test {
 protected:
  SearchCase search_{empty_room(16, 10), {3, 3}, {test_person()}};
  TimedPath waiting_{{{0.0, {3, 3}}}};
  TimedPath walk_{{{0.0, {3, 3}}, {4.0, {7, 3}}}};
};

TEST_F(SearchProblemTest, StandingStillForNoTimeFindsNothing) {
  const JointPlan plan = evaluated(search_.problem, {waiting_});
  EXPECT_DOUBLE_EQ(plan.forecast.probability_found, 0.0);
  EXPECT_DOUBLE_EQ(plan.value_s, search_.problem.horizon_s + search_.problem.tail_s);
}

TEST_F(SearchProblemTest, GoingSomewhereIsBetterThanWaiting) {
  const JointPlan going = evaluated(search_.problem, {walk_});
  EXPECT_GT(going.forecast.probability_found, 0.0);
  EXPECT_LT(going.value_s, evaluated(search_.problem, {waiting_}).value_s);
}

TEST_F(SearchProblemTest, TheSurvivalFallsToWhatTheForecastPromises) {
  const auto survival = survival_of(search_.problem, {walk_}, 0.5);
  EXPECT_TRUE(std::is_sorted(survival.rbegin(), survival.rend()));
  EXPECT_NEAR(1.0 - survival.back(), evaluated(search_.problem, {walk_}).forecast.probability_found, 1e-12);
}

TEST_F(SearchProblemTest, ARejectedPlanIsWorthLessThanAnyOther) {
  const JointPlan plan = evaluated(search_.problem, {walk_});
  search_.problem.rejected.push_back({walk_});
  EXPECT_DOUBLE_EQ(evaluated(search_.problem, {walk_}).value_s, plan.value_s + kRejectedPenalty_s);
}

TEST_F(SearchProblemTest, WhatOthersLookAtAnywayNeedsNoLook) {
  const JointPlan alone = evaluated(search_.problem, {walk_});
  search_.problem.others.push_back({0, 0.0, walk_});
  EXPECT_DOUBLE_EQ(evaluated(search_.problem, {waiting_}).value_s, alone.value_s);
}

TEST_F(SearchProblemTest, APersonWhoMayNotFollowCountsByHowLikelyThatIs) {
  const double following_s = evaluated(search_.problem, {walk_}).value_s;
  const double waiting_s = evaluated(search_.problem, {waiting_}).value_s;
  search_.problem.members[0].hypotheses.push_back({0.25, waiting_});
  EXPECT_NEAR(evaluated(search_.problem, {walk_}).value_s, 0.75 * following_s + 0.25 * waiting_s, 1e-9);
}

TEST_F(SearchProblemTest, AGoalIsReachedAtTheFirstCornerNearIt) {
  search_.problem.members[0].goal = Vector2d{7.3, 3};
  EXPECT_DOUBLE_EQ(evaluated(search_.problem, {walk_}).goal_reached_s[0], 4.0);
  search_.problem.members[0].goal = Vector2d{9, 3};
  EXPECT_TRUE(std::isinf(evaluated(search_.problem, {walk_}).goal_reached_s[0]));
}

TEST(PathUntil, EndsWhereOneIsThen) {
  const TimedPath half = path_until({{{0.0, {0, 0}}, {4.0, {4, 0}}, {8.0, {4, 4}}}}, 6.0);
  ASSERT_EQ(half.points.size(), 3U);
  EXPECT_DOUBLE_EQ(half.duration_s(), 6.0);
  EXPECT_EQ(half.points.back().point_in_map, (Vector2d{4, 2}));
}

}  // namespace
}  // namespace tandem
