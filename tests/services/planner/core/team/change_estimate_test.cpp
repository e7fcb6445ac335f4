#include "services/planner/core/team/change_estimate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "services/common/random.hpp"
#include "services/planner/core/team/route_value.hpp"
#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

Searcher who_finds(Searcher searcher) {
  searcher.detection_rate_per_s = std::numeric_limits<double>::infinity();
  searcher.field_of_view_rad = 2.0 * std::numbers::pi;
  return searcher;
}

/// A hall in which seen is found, with walks of two through it that end before the horizon.
struct Hall {
  static const SearchProblem& problem_of(SearchCase& search) {
    search.problem.horizon_s = 1000.0;
    return search.problem;
  }
  SearchCase search{empty_room(24, 16), {3, 3}, {who_finds(test_robot()), who_finds(test_person())}};
  PreparedProblem prepared{problem_of(search)};
  TeamGround ground = team_ground(prepared);
  RouteValue value{ground};
  ChangeEstimate estimate{ground};

  [[nodiscard]] int random_near(std::size_t m, int place, Rng& rng) {
    const auto& near = ground.books[m]->actions().nearest_lookouts(place);
    return near[rng.index(near.size())];
  }
  [[nodiscard]] Routes random_walks(int places, Rng& rng) {
    Routes routes(2);
    for (std::size_t m = 0; m < 2; ++m) {
      int at = prepared.members()[m].start;
      for (int i = 0; i < places; ++i) routes[m].push_back(at = random_near(m, at, rng));
    }
    return routes;
  }
};

TEST(ChangeEstimate, WithoutAChangeNothingChanges) {
  Hall hall;
  Rng rng{1};
  const Routes routes = hall.random_walks(12, rng);
  hall.estimate.rebase(routes);
  EXPECT_DOUBLE_EQ(hall.estimate.change_s(routes).value(), 0.0);
}

TEST(ChangeEstimate, OfTheLastLegIsExact) {
  Hall hall;
  Rng rng{2};
  for (int i = 0; i < 50; ++i) {
    const Routes routes = hall.random_walks(10, rng);
    Routes trial = routes;
    const std::size_t m = rng.index(2);
    const int before = trial[m][trial[m].size() - 2];
    trial[m].back() = hall.random_near(m, before, rng);
    hall.estimate.rebase(routes);
    EXPECT_NEAR(hall.estimate.change_s(trial).value(), hall.value.value_s(trial) - hall.value.value_s(routes), 1e-3);
  }
}

TEST(ChangeEstimate, OfAnInsertedPlaceIsNearlyRight) {
  Hall hall;
  Rng rng{3};
  double error_s = 0.0;
  double change_s = 0.0;
  for (int i = 0; i < 200; ++i) {
    const Routes routes = hall.random_walks(14, rng);
    Routes trial = routes;
    const std::size_t m = rng.index(2);
    const std::size_t at = 1 + rng.index(trial[m].size() - 1);
    const int place = hall.random_near(m, trial[m][at - 1], rng);
    trial[m].insert(trial[m].begin() + static_cast<std::ptrdiff_t>(at), place);
    trial[m] = hall.ground.books[m]->actions().joined(hall.prepared.members()[m].start, trial[m]);
    hall.estimate.rebase(routes);
    const double exact_s = hall.value.value_s(trial) - hall.value.value_s(routes);
    error_s += std::abs(hall.estimate.change_s(trial).value() - exact_s);
    change_s += std::abs(exact_s);
  }
  EXPECT_LT(error_s, 0.1 * change_s);
}

TEST(ChangeEstimate, AcceptingIsTheSameAsStartingFromTheTrial) {
  Hall hall;
  Rng rng{4};
  Routes routes = hall.random_walks(12, rng);
  hall.estimate.rebase(routes);
  ChangeEstimate fresh(hall.ground);
  for (int i = 0; i < 100; ++i) {
    Routes trial = routes;
    const std::size_t m = rng.index(2);
    // The last legs only: there nothing behind the change is shifted, so both know the same.
    trial[m].back() = hall.random_near(m, trial[m][trial[m].size() - 2], rng);
    ASSERT_TRUE(hall.estimate.change_s(trial));
    hall.estimate.accept(trial);
    routes = trial;
    Routes next = routes;
    const std::size_t other = rng.index(2);
    next[other].push_back(hall.random_near(other, next[other].back(), rng));
    fresh.rebase(routes);
    EXPECT_NEAR(hall.estimate.change_s(next).value(), fresh.change_s(next).value(), 1e-4);
  }
}

TEST(ChangeEstimate, SaysSoIfTheChangeIsNotASmallOne) {
  Hall hall;
  Rng rng{5};
  const Routes routes = hall.random_walks(60, rng);
  Routes trial = routes;
  std::ranges::reverse(trial[0]);
  trial[0] = hall.ground.books[0]->actions().joined(hall.prepared.members()[0].start, trial[0]);
  hall.estimate.rebase(routes);
  EXPECT_FALSE(hall.estimate.change_s(trial));
}

}  // namespace
}  // namespace tandem
