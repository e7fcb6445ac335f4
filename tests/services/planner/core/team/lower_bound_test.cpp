#include "services/planner/core/team/lower_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "services/planner/core/team/tandem_planner.hpp"
#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

constexpr double kFirstSight = std::numeric_limits<double>::infinity();
constexpr double kSlack_s = 1e-6;

Searcher sharp(double speed_mps = 1.0, double view_max_m = 1.0) {
  Searcher person = test_person();
  person.detection_rate_per_s = kFirstSight;
  person.view_max_m = view_max_m;
  person.speed_mps = speed_mps;
  return person;
}

double bound_s(const SearchProblem& problem) {
  return lower_bound_s(PreparedProblem(problem));
}

/// A room of 9 m x 6 m with a few columns, uneven mass.
SearchCase random_case(std::uint64_t seed, std::vector<Searcher> searchers) {
  Rng rng{seed};
  std::vector<std::string> drawing(14, "#" + std::string(18, '.') + "#");
  drawing.front() = drawing.back() = std::string(20, '#');
  for (int column = 0; column < 10; ++column) drawing[1 + rng.index(12)][5 + rng.index(14)] = '#';
  SearchCase search(room(drawing), {1.5, 1.5}, std::move(searchers), 1.0);
  for (double& mass : search.problem.masses.front()) mass *= rng.uniform() < 0.3 ? 0.0 : rng.uniform();
  search.problem.horizon_s = rng.uniform(10.0, 60.0);
  search.problem.tail_s = 20.0;
  return search;
}

/// The ways on from a place: all that near legs lead to.
std::vector<int> ways_on(const PreparedProblem::Member& member, int place) {
  std::vector<int> next = member.actions->near_lookouts(place);
  if (member.goal && place != *member.goal && member.actions->is_near(place, *member.goal)) {
    next.push_back(*member.goal);
  }
  return next;
}

Routes random_routes(const PreparedProblem& prepared, Rng& rng) {
  Routes routes;
  for (const PreparedProblem::Member& member : prepared.members()) {
    std::vector<int>& route = routes.emplace_back();
    double time_s = member.start_s;
    for (int place = member.start; place >= 0 && time_s < prepared.problem().horizon_s;) {
      const std::vector<int> next = ways_on(member, place);
      if (next.empty()) break;
      route.push_back(next[rng.index(next.size())]);
      time_s += std::max(0.1, member.actions->leg(place, route.back()).duration_s);
      place = route.back();
    }
  }
  return routes;
}

void expect_below_plans(const SearchProblem& problem, std::uint64_t seed) {
  const double lower_s = bound_s(problem);
  EXPECT_GT(lower_s, 0.0) << "world " << seed;
  const PreparedProblem prepared(problem);
  Rng rng{seed};
  for (int i = 0; i < 10; ++i) {
    const JointPlan plan = prepared.plan(random_routes(prepared, rng));
    EXPECT_LE(lower_s, plan.forecast.expected_time_s + kSlack_s) << "world " << seed << ", routes " << i;
  }
}

/// The best plan of one member among all walks over near legs.
double best_walk_s(const PreparedProblem& prepared) {
  const PreparedProblem::Member& member = prepared.members().front();
  double best_s = prepared.plan({{}}).forecast.expected_time_s;
  std::vector<int> route;
  const std::function<void(int, double)> go_on = [&](int place, double time_s) {
    if (time_s >= prepared.problem().horizon_s) {
      best_s = std::min(best_s, prepared.plan({route}).forecast.expected_time_s);
      return;
    }
    for (const int next : ways_on(member, place)) {
      route.push_back(next);
      go_on(next, time_s + std::max(0.1, member.actions->leg(place, next).duration_s));
      route.pop_back();
    }
  };
  go_on(member.start, member.start_s);
  return best_s;
}

TEST(LowerBound, AnObjectFarAheadIsNotFoundBeforeOneIsWithinViewOfIt) {
  SearchCase search(empty_room(20, 1), {1.75, 1.0}, {sharp()}, 0.8);
  auto& mass = search.problem.masses.front();
  std::fill(mass.begin(), mass.end(), 0.0);
  mass[static_cast<std::size_t>(*search.world().area().cell_at({18.75, 1.25}))] = 1.0;
  // Seen from 1 m, so not before the search cell that begins at 17.5 m: 15.75 s to walk; from that at 18 m at the
  // latest.
  EXPECT_GE(bound_s(search.problem), 15.75);
  EXPECT_LE(bound_s(search.problem), 16.25);
}

TEST(LowerBound, IsTightWhereOneWayShowsEverything) {
  SearchCase search(empty_room(20, 1), {1.0, 1.0}, {sharp()}, 0.8);
  TandemPlanner planner({});
  const JointPlan plan = plan_with(planner, search.problem, 50, 1);
  EXPECT_LE(planner.lower_bound_s(), plan.forecast.expected_time_s);
  EXPECT_GE(planner.lower_bound_s(), 0.9 * plan.forecast.expected_time_s);
}

TEST(LowerBound, IsNotAboveTheBestOfAllWalksInSmallWorlds) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Rng rng{seed};
    SearchCase search(room({"##########", "#...#....#", "#........#", "#..#.....#", "##########"}), {1.25, 1.25},
                      {sharp(1.0, rng.uniform(0.6, 1.2))}, 0.6);
    for (double& mass : search.problem.masses.front()) mass = rng.uniform() < 0.5 ? rng.uniform() : 0.0;
    search.problem.horizon_s = 5.0;
    search.problem.tail_s = 5.0;
    const double lower_s = bound_s(search.problem);
    const double best_s = best_walk_s(PreparedProblem(search.problem));
    EXPECT_LE(lower_s, best_s + kSlack_s) << "world " << seed;
    EXPECT_GE(lower_s, 0.4 * best_s) << "world " << seed;
  }
}

TEST(LowerBound, T20NoPlanIsBetterThanItIn200Worlds) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Rng rng{1000 + seed};
    std::vector<Searcher> team{sharp(rng.uniform(0.5, 1.5), rng.uniform(0.8, 2.0))};
    if (seed % 3 != 0) team.push_back(sharp(rng.uniform(0.5, 1.5), 1.5));
    if (seed % 3 == 2) team.push_back(team.front());
    SearchCase search = random_case(seed, std::move(team));
    if (seed % 4 == 0) search.problem.others.push_back({0, 0.0, {{{0.0, {1.5, 5.0}}, {10.0, {8.0, 5.0}}}}});
    if (seed % 5 == 0) search.problem.members[0].goal = Eigen::Vector2d{8.0, 1.25};
    if (seed % 7 == 0) search.problem.members[0].committed = {{{0.0, {1.5, 1.5}}, {2.0, {1.5, 3.5}}}};
    expect_below_plans(search.problem, seed);
    TandemPlanner planner({});
    const JointPlan plan = plan_with(planner, search.problem, 20, seed);
    EXPECT_LE(planner.lower_bound_s(), plan.forecast.expected_time_s) << "world " << seed;
  }
}

TEST(LowerBound, NoPlanIsBetterWhereALookMayMissTheObject) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Rng rng{2000 + seed};
    Searcher person = test_person();
    person.view_max_m = 1.5;
    person.detection_rate_per_s = rng.uniform(0.2, 3.0);
    Searcher robot = test_robot();
    robot.view_max_m = 2.0;
    robot.detection_rate_per_s = seed % 2 == 0 ? kFirstSight : rng.uniform(0.2, 3.0);
    std::vector<Searcher> team{person};
    if (seed % 3 != 0) team.push_back(robot);
    if (seed % 3 == 2) team.front() = robot;
    SearchCase search = random_case(seed, std::move(team));
    if (seed % 4 == 0) search.problem.others.push_back({0, 0.0, {{{0.0, {1.5, 5.0}}, {10.0, {8.0, 5.0}}}}});
    expect_below_plans(search.problem, seed);
  }
}

TEST(LowerBound, OfSeveralObjectsIsAtLeastThatOfEach) {
  SearchCase search = random_case(3, {sharp(), sharp(0.5)});
  const std::vector<double> one = search.problem.masses.front();
  std::vector<double> other(one.rbegin(), one.rend());
  const double one_s = bound_s(search.problem);
  search.problem.masses = {one, other};
  EXPECT_GT(bound_s(search.problem), one_s);
  expect_below_plans(search.problem, 3);
}

TEST(LowerBound, MoreMembersNeverRaiseIt) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SearchCase search = random_case(seed, {sharp(), sharp(0.5), sharp(0.8, 1.5)});
    double fewer_s = kFirstSight;
    const std::vector<SearchMember> members = search.problem.members;
    for (std::size_t count = 1; count <= members.size(); ++count) {
      search.problem.members.assign(members.begin(), members.begin() + static_cast<std::ptrdiff_t>(count));
      const double lower_s = bound_s(search.problem);
      EXPECT_LT(lower_s, fewer_s) << "world " << seed << ", members " << count;
      fewer_s = lower_s;
    }
  }
}

TEST(LowerBound, WhatIsLookedAtAnywayLowersIt) {
  SearchCase search(empty_room(16, 10), {3, 3}, {test_person()});
  const double alone_s = bound_s(search.problem);
  search.problem.others.push_back({0, 0.0, {{{0.0, {3, 3}}, {10.0, {12, 3}}}}});
  EXPECT_LT(bound_s(search.problem), alone_s);
}

TEST(LowerBound, IsTheMeanOverWhatAPersonMayDo) {
  SearchCase search(empty_room(8, 6), {3, 3}, {test_person()});
  const double follows_s = bound_s(search.problem);
  search.problem.members[0].hypotheses.push_back({0.25, {{{0.0, {3, 3}}}}});  // looks nowhere
  const double never_s = search.problem.horizon_s + search.problem.tail_s;
  EXPECT_NEAR(bound_s(search.problem), 0.75 * follows_s + 0.25 * never_s, 1e-3);
}

TEST(LowerBound, IsNotKnownWhereNearLegsDoNotLeadEverywhere) {
  SearchWorldOptions options;
  options.area = start_at(3, 3);
  options.searchers = {sharp()};
  options.nearest = 1;
  SearchWorld world({empty_room(8, 6)}, options);
  SearchProblem problem;
  problem.world = &world;
  problem.members.resize(1);
  problem.members.front().pose = {3.0, 3.0, 0.0};
  problem.masses = {uniform_prior(world.area(), {3, 3}, 0.0)};
  EXPECT_DOUBLE_EQ(bound_s(problem), 0.0);
}

}  // namespace
}  // namespace tandem
