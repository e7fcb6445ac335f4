#include "services/planner/core/team/team_ground.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <set>

#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

TEST(TeamGround, TheMassOfSeveralObjectsAddsUp) {
  SearchCase search(empty_room(8, 6), {3, 3}, {test_person()});
  search.problem.masses.push_back(search.problem.masses.front());
  const PreparedProblem prepared(search.problem);
  const TeamGround ground = team_ground(prepared);
  EXPECT_NEAR(std::accumulate(ground.mass.begin(), ground.mass.end(), 0.0), 2.0, 1e-5);
}

TEST(TeamGround, WhatIsLookedAtAnywayIsNotToBePromised) {
  SearchCase search(empty_room(8, 6), {3, 3}, {test_person()});
  search.problem.others.push_back({0, 0.0, {{{0.0, {3, 3}}, {4.0, {6, 3}}}}});
  const PreparedProblem prepared(search.problem);
  const TeamGround ground = team_ground(prepared);
  const auto cell = static_cast<std::size_t>(*search.world().area().cell_at({4, 3}));
  EXPECT_LT(ground.unpromised[cell], 0.5F * ground.mass[cell]);
}

TEST(TeamGround, ALegTakesWhatItDetects) {
  Searcher person = test_person();
  person.detection_rate_per_s = std::numeric_limits<double>::infinity();
  SearchCase search(empty_room(8, 6), {3, 3}, {person});
  const CompactLeg& leg = search.world().book(0).leg(0, 1);
  std::vector<float> mass(static_cast<std::size_t>(search.world().area().size()), 1.0F);
  const std::set<std::int32_t> different(leg.cells.begin(), leg.cells.end());
  EXPECT_FLOAT_EQ(take_detected(leg, leg.cells.size(), true, mass), static_cast<float>(different.size()));
  EXPECT_FLOAT_EQ(take_detected(leg, leg.cells.size(), true, mass), 0.0F);
}

TEST(TeamGround, OfALegThatIsCutShortOnlyWhatWasSeenCounts) {
  CompactLeg leg;
  leg.duration_s = 4.0F;
  leg.cells = {0, 1, 2};
  leg.enter_s = {0.0F, 1.0F, 3.0F};
  EXPECT_EQ(cells_until(leg, 4.0), 3U);
  EXPECT_EQ(cells_until(leg, 3.5), 3U);
  EXPECT_EQ(cells_until(leg, 3.0), 2U);
  EXPECT_EQ(cells_until(leg, 0.0), 0U);
  EXPECT_EQ(cells_until(leg, -1.0), 0U);
  std::vector<float> mass(3, 1.0F);
  EXPECT_FLOAT_EQ(take_detected(leg, 2, true, mass), 2.0F);
  EXPECT_FLOAT_EQ(mass[2], 1.0F);
}

}  // namespace
}  // namespace tandem
