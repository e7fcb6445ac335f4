#include "services/planner/core/team/near_legs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

TEST(NearLegs, OfMembersWhoMoveAndSeeAlikeAreKeptOnce) {
  SearchCase search(empty_room(8, 6), {3, 3}, {test_person(), test_robot(), test_person()});
  const PreparedProblem prepared(search.problem);
  const auto near = near_legs(prepared);
  ASSERT_EQ(near.size(), 2U);
  EXPECT_EQ(near[0].members, (std::vector<std::size_t>{0, 2}));
  EXPECT_TRUE(near[0].complete);
}

TEST(NearLegs, SaysWhenAPlaceCanBeReached) {
  SearchCase search(empty_room(12, 1), {1.5, 1.0}, {test_person()}, 1.0);
  search.problem.members[0].committed = {{{0.0, {1.5, 1.0}}, {4.0, {4.5, 1.0}}}};
  const PreparedProblem prepared(search.problem);
  const NearLegs near = near_legs(prepared).front();
  for (int place = 0; place < near.actions->lookouts(); ++place) {
    const double walk_s = std::abs(near.actions->place(place).x() - 4.5) / test_person().speed_mps;
    EXPECT_NEAR(near.earliest_s[static_cast<std::size_t>(place)], 4.0 + walk_s, 0.5);
  }
}

TEST(NearLegs, LeadToAGoalFromTheLookoutsNearItAndFromTheStart) {
  SearchCase search(empty_room(12, 6), {3, 3}, {test_person()}, 1.0);
  search.problem.members[0].goal = Eigen::Vector2d{10.0, 4.0};
  const PreparedProblem prepared(search.problem);
  const int goal = *prepared.members()[0].goal;
  const NearLegs near = near_legs(prepared).front();
  std::vector<int> around = near.actions->near_lookouts(goal);
  around.push_back(prepared.members()[0].start);
  for (const NearLegs::Entry& entry : near.legs) {
    if (entry.to == goal) {
      EXPECT_NE(std::ranges::find(around, entry.from), around.end());
    }
  }
  EXPECT_EQ(std::ranges::count(near.legs, goal, &NearLegs::Entry::to), std::ranges::ssize(around));
}

TEST(NearLegs, AreNotCompleteWhereSomeLookoutIsNearToNone) {
  SearchWorldOptions options;
  options.area = start_at(3, 3);
  options.searchers = {test_person()};
  options.nearest = 1;
  SearchWorld world({empty_room(20, 10)}, options);
  SearchProblem problem;
  problem.world = &world;
  problem.members.resize(1);
  problem.members.front().pose = {3.0, 3.0, 0.0};
  problem.masses = {uniform_prior(world.area(), {3, 3}, 0.0)};
  EXPECT_FALSE(near_legs(PreparedProblem(problem)).front().complete);
}

}  // namespace
}  // namespace tandem
