#include "services/planner/core/team/lower_bound.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "services/planner/core/team/tandem_planner.hpp"
#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

Searcher sharp() {
  Searcher person = test_person();
  person.detection_rate_per_s = std::numeric_limits<double>::infinity();
  person.view_max_m = 1.0;
  person.speed_mps = 1.0;
  return person;
}

TEST(LowerBound, AnObjectFarAheadIsNotFoundBeforeOneIsWithinViewOfIt) {
  SearchCase search(empty_room(20, 1), {1.5, 1.0}, {sharp()}, 0.8);
  auto& mass = search.problem.masses.front();
  std::fill(mass.begin(), mass.end(), 0.0);
  mass[static_cast<std::size_t>(*search.world().area().cell_at({18.75, 1.0}))] = 1.0;
  search.problem.horizon_s = 100.0;
  // 17.25 m away, seen from 1.71 m at most: 15.5 s, in steps of 0.5 s.
  EXPECT_NEAR(lower_bound_s(PreparedProblem(search.problem)), 15.5, 0.6);
}

TEST(LowerBound, T20NoPlanIsBetterThanIt) {
  SearchCase search(empty_room(16, 10), {3, 3}, {test_robot(), test_person()});
  TandemPlanner planner({});
  const JointPlan plan = plan_with(planner, search.problem, 50, 1);
  EXPECT_GT(plan.lower_bound_s, 0.0);
  EXPECT_LE(plan.lower_bound_s, plan.forecast.expected_time_s);
}

TEST(LowerBound, IsNotKnownIfAPersonMayNotFollow) {
  SearchCase search(empty_room(8, 6), {3, 3}, {test_person()});
  search.problem.members[0].hypotheses.push_back({0.5, {{{0.0, {3, 3}}}}});
  EXPECT_DOUBLE_EQ(lower_bound_s(PreparedProblem(search.problem)), 0.0);
}

TEST(LowerBound, WhatIsLookedAtAnywayLowersIt) {
  SearchCase search(empty_room(16, 10), {3, 3}, {test_person()});
  const double alone_s = lower_bound_s(PreparedProblem(search.problem));
  search.problem.others.push_back({0, 0.0, {{{0.0, {3, 3}}, {10.0, {12, 3}}}}});
  EXPECT_LT(lower_bound_s(PreparedProblem(search.problem)), alone_s);
}

}  // namespace
}  // namespace tandem
