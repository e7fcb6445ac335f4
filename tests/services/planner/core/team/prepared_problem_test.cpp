#include "services/planner/core/team/prepared_problem.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

TEST(PreparedProblem, ThePathOfARouteBeginsAtThePoseAndEndsAtItsLastPlace) {
  SearchCase search(empty_room(16, 10), {3, 3}, {test_person()});
  const PreparedProblem prepared(search.problem);
  const TimedPath path = prepared.path(0, {1, 2});

  EXPECT_EQ(path.points.front().point_in_map, (Vector2d{3, 3}));
  EXPECT_EQ(path.points.back().point_in_map, search.world().actions(0).place(2));
}

TEST(PreparedProblem, TheLooksOfLegsAreWorthTheSameAsTheWholePath) {
  SearchCase search(empty_room(16, 10), {3, 3}, {test_person(), test_robot()});
  const PreparedProblem prepared(search.problem);
  const Routes routes{{0, 4, 2}, {1, 3, 5}};
  std::vector<Look> looks = prepared.fixed_looks();
  for (std::size_t m = 0; m < 2; ++m) prepared.add_looks(m, routes[m], looks);
  SearchObjective objective(search.problem.masses, search.problem.horizon_s, search.problem.tail_s);

  EXPECT_NEAR(objective.forecast(looks).expected_time_s, prepared.plan(routes).value_s, 1e-6);
}

TEST(PreparedProblem, WhatIsCommittedIsWalkedFirst) {
  SearchCase search(empty_room(16, 10), {3, 3}, {test_person()});
  search.problem.members[0].committed = {{{0.0, {3, 3}}, {4.0, {6, 3}}}};
  const PreparedProblem prepared(search.problem);
  const TimedPath path = prepared.path(0, {1});

  EXPECT_DOUBLE_EQ(prepared.members()[0].start_s, 4.0);
  EXPECT_EQ(prepared.fixed_looks().size(), 1U);
  EXPECT_EQ(pose_at(path, 4.0).position(), (Vector2d{6, 3}));
}

TEST(PreparedProblem, ABatteryEndsAPlan) {
  SearchCase search(empty_room(16, 10), {3, 3}, {test_person()});
  search.problem.members[0].battery_s = 4.0;
  const PreparedProblem prepared(search.problem);
  const Routes routes{{1, 2, 3}};
  const JointPlan plan = prepared.plan(routes);
  std::vector<Look> looks;
  prepared.add_looks(0, routes[0], looks);

  EXPECT_DOUBLE_EQ(prepared.members()[0].end_s, 4.0);
  EXPECT_DOUBLE_EQ(plan.paths[0].duration_s(), 4.0);
  SearchObjective objective(search.problem.masses, search.problem.horizon_s, search.problem.tail_s);
  EXPECT_NEAR(objective.forecast(looks).expected_time_s, plan.value_s, 1e-3);
  search.problem.members[0].battery_s = 1e9;
  EXPECT_GT(PreparedProblem(search.problem).plan(routes).paths[0].duration_s(), 5.0);
}

TEST(PreparedProblem, AGoalThatCannotBeReachedIsNone) {
  SearchCase search(empty_room(16, 10), {3, 3}, {test_person()});
  search.problem.members[0].goal = Vector2d{100, 3};
  EXPECT_FALSE(PreparedProblem(search.problem).members()[0].goal);
  search.problem.members[0].goal = Vector2d{10, 3};
  EXPECT_TRUE(PreparedProblem(search.problem).members()[0].goal);
}

}  // namespace
}  // namespace tandem
