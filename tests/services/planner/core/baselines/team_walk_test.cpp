#include "services/planner/core/baselines/team_walk.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/services/planner/support/search_corridor.hpp"

namespace tandem {
namespace {

TEST(TeamWalk, WhoeverArrivesFirstChooses) {
  SearchCase search = corridor(2);
  const PreparedProblem problem(search.problem);
  TeamWalk walk(problem, 40);
  EXPECT_EQ(walk.next_member(), 0);
  walk.go(0, walk.options(0).front().place);
  EXPECT_EQ(walk.next_member(), 1);
  walk.stay(1);
  EXPECT_EQ(walk.next_member(), 0);
  walk.stay(0);
  EXPECT_EQ(walk.next_member(), -1);
}

TEST(TeamWalk, OptionsAreTheNearestThatShowSomethingNewAndWhatOneSeesIsNotNewToTheOther) {
  SearchCase search = corridor(2);
  place_mass(search, 2.75, 0.2, 10.25, 0.8);
  const PreparedProblem problem(search.problem);
  TeamWalk walk(problem, 1);
  const auto first = walk.options(0);
  ASSERT_EQ(first.size(), 1U);
  EXPECT_DOUBLE_EQ(first.front().gain, 0.2);
  walk.go(0, first.front().place);
  EXPECT_NEAR(std::accumulate(walk.mass().begin(), walk.mass().end(), 0.0), 0.8, 1e-12);
  EXPECT_DOUBLE_EQ(walk.options(1).front().gain, 0.8);
}

TEST(TeamWalk, HowLittleIsNothingIsMeasuredByAllTheMassThereIs) {
  SearchCase search = corridor(1);
  place_mass(search, 2.75, 0.2e-13, 10.25, 0.8e-13);
  const PreparedProblem little(search.problem);
  EXPECT_FALSE(TeamWalk(little, 1).options(0).empty());
  place_mass(search, 2.75, 1e-10, 10.25, 1e10);  // the nearer one is rounding
  const PreparedProblem much(search.problem);
  const TeamWalk walk(much, 1);
  ASSERT_EQ(walk.options(0).size(), 1U);
  EXPECT_DOUBLE_EQ(walk.options(0).front().gain, 1e10);
}

TEST(TeamWalk, TheWayToAFixedGoalMayBeADetourButNotAnyDetour) {
  SearchCase search = corridor(1);
  search.problem.members[0].goal = Eigen::Vector2d{5.75, 1.0};  // 1 m away: at most 5.5 m may be walked
  place_mass(search, 2.75, 0.5, 11.25, 0.5);
  const PreparedProblem problem(search.problem);
  const TeamWalk walk(problem, 40);
  const auto options = walk.options(0);
  EXPECT_EQ(options.back().place, *problem.members()[0].goal);
  for (const WalkOption& option : options) {
    EXPECT_LT(problem.members()[0].actions->place(option.place).x(), 8.5);  // there and back would be too far
  }
  TeamWalk straight(problem, 40);
  straight.go(0, *problem.members()[0].goal);
  EXPECT_EQ(straight.next_member(), -1);
}

}  // namespace
}  // namespace tandem
