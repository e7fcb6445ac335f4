#include "services/planner/core/search/belief_edit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "services/common/random.hpp"
#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

using Kind = BeliefEdit::Kind;

constexpr std::size_t kPerson = 1;

/// A hall of 4 m x 2 m in 32 cells of 0.5 m, all alike; the left quarter of it is 8 of them.
struct Hall {
  OccupancyGrid map = empty_room(4, 2);
  SearchArea area{map, start_at(2, 1.5)};
  SearchBelief belief{std::vector<double>(static_cast<std::size_t>(area.size()), 1.0 / area.size())};

  std::optional<std::string> edit(Kind kind, const PlanarShape& region, const std::string& strength = "") {
    return edit_belief(belief, area, {kind, region, strength}, kPerson);
  }
  /// The posterior of all cells in the left quarter.
  [[nodiscard]] double left_quarter() const {
    const auto posterior = belief.posterior();
    double sum = 0.0;
    for (int cell = 0; cell < area.size(); ++cell) {
      if (contains(kLeftQuarter, area.point(cell))) sum += posterior[static_cast<std::size_t>(cell)];
    }
    return sum;
  }
  inline static const PlanarShape kLeftQuarter = Polygon{{{0.5, 0.5}, {1.5, 0.5}, {1.5, 2.5}, {0.5, 2.5}}};
  inline static const PlanarShape kFarAway = Disc{{50, 50}, 1.0};
};

TEST(BeliefEdit, TheHallHasFourEqualQuarters) {
  const Hall hall;
  ASSERT_EQ(hall.area.size(), 32);
  EXPECT_NEAR(hall.left_quarter(), 0.25, 1e-12);
}

TEST(BeliefEdit, LikelyHereMultipliesTheOdds) {
  Hall hall;
  EXPECT_FALSE(hall.edit(Kind::LikelyHere, Hall::kLeftQuarter, "quite"));
  EXPECT_NEAR(hall.left_quarter(), 4.0 / 7.0, 1e-12);  // 4 x 1/4 against 3/4
  EXPECT_FALSE(hall.edit(Kind::LikelyHere, Hall::kLeftQuarter, "a bit"));
  EXPECT_NEAR(hall.left_quarter(), 2.0 / 5.0, 1e-12);  // in place of what was said before
}

TEST(BeliefEdit, NotHereDividesTheOdds) {
  Hall hall;
  EXPECT_FALSE(hall.edit(Kind::NotHere, Hall::kLeftQuarter, "very"));
  EXPECT_NEAR(hall.left_quarter(), 1.0 / 31.0, 1e-12);  // 1/40 against 3/4
}

TEST(BeliefEdit, ASearchedPlaceHasBeenLookedAtOnce) {
  Hall hall;
  EXPECT_FALSE(hall.edit(Kind::Searched, Hall::kLeftQuarter, "well"));
  EXPECT_FALSE(hall.edit(Kind::Searched, Hall::kLeftQuarter, "roughly"));  // no more than well
  EXPECT_NEAR(hall.belief.probability_left(), 0.75 + 0.25 * std::exp(-2.0), 1e-12);
  EXPECT_NEAR(explored_shares(hall.area, hall.belief, 2, 0.5).by_agent[kPerson], 0.25, 1e-9);
}

TEST(BeliefEdit, LookingAgainGivesBackWhatWasThere) {
  Hall hall;
  hall.belief.look(0, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, 1.0, 5.0);
  EXPECT_FALSE(hall.edit(Kind::Searched, Hall::kLeftQuarter));
  EXPECT_FALSE(hall.edit(Kind::NotHere, Hall::kLeftQuarter));
  const PlanarShape everywhere = Disc{{2, 1}, 10.0};
  EXPECT_FALSE(hall.edit(Kind::LookAgain, everywhere));
  EXPECT_NEAR(hall.left_quarter(), 0.25, 1e-12);
  EXPECT_NEAR(hall.belief.probability_left(), 1.0, 1e-12);
  EXPECT_EQ(explored_shares(hall.area, hall.belief, 2, 0.5).all, 0.0);
}

TEST(BeliefEdit, ASmallMarkMeansTheCellItIsIn) {
  Hall hall;
  EXPECT_FALSE(hall.edit(Kind::NotHere, Disc{{0.6, 0.6}, 0.01}));
  const auto cell = hall.area.cell_at({0.6, 0.6});
  EXPECT_NEAR(hall.belief.mass()[static_cast<std::size_t>(*cell)] / hall.belief.mass()[31], 0.25, 1e-12);
}

TEST(BeliefEdit, WhatMakesNoSenseIsRefusedAndChangesNothing) {
  Hall hall;
  EXPECT_EQ(hall.edit(Kind::LikelyHere, Hall::kFarAway), "nothing is searched there");
  EXPECT_EQ(hall.edit(Kind::NotHere, Hall::kLeftQuarter, "well"), "nobody knows how much \"well\" is");
  EXPECT_EQ(hall.edit(Kind::Searched, Hall::kLeftQuarter, "very"), "nobody knows how much \"very\" is");
  EXPECT_NEAR(hall.left_quarter(), 0.25, 1e-12);
}

TEST(BeliefEdit, ALookIsALookWhetherItComesBeforeOrAfterAHint) {
  Hall before;
  before.belief.look(0, {0, 1, 2}, 0.5, 1.0);
  EXPECT_FALSE(before.edit(Kind::LikelyHere, Hall::kLeftQuarter));
  Hall after;
  EXPECT_FALSE(after.edit(Kind::LikelyHere, Hall::kLeftQuarter));
  after.belief.look(0, {0, 1, 2}, 0.5, 1.0);
  for (std::size_t i = 0; i < 32; ++i) EXPECT_NEAR(before.belief.mass()[i], after.belief.mass()[i], 1e-12);
}

TEST(BeliefEdit, WhateverIsSaidTheProbabilitiesAddUp) {
  Rng rng{6};
  Hall hall;
  std::vector<double> exposure(32, 0.0);
  for (int i = 0; i < 200; ++i) {
    const PlanarShape region = Disc{{rng.uniform(0.5, 4.5), rng.uniform(0.5, 2.5)}, rng.uniform(0.1, 2.0)};
    const auto kind = static_cast<Kind>(i % 4);
    EXPECT_FALSE(hall.edit(kind, region, kind == Kind::Searched ? "roughly" : "very"));
    hall.belief.look(0, {i % 32}, 1.0, 0.1);
    const auto posterior = hall.belief.posterior();
    EXPECT_NEAR(std::accumulate(posterior.begin(), posterior.end(), 0.0), 1.0, 1e-12);
    double left_and_detected = 0.0;  // mass = share exp(-exposure): the shares are all there is
    for (std::size_t c = 0; c < 32; ++c) {
      left_and_detected += hall.belief.mass()[c] * std::exp(hall.belief.exposure(static_cast<int>(c)));
    }
    EXPECT_NEAR(left_and_detected, 1.0, 1e-9);
  }
}

/// The expected time of visiting cells in the order of `guide`, likeliest first, one a second, if `truth` is right.
double expected_time_s(const std::vector<double>& guide, const std::vector<double>& truth) {
  std::vector<std::size_t> order(guide.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return guide[a] > guide[b]; });
  double sum_s = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) sum_s += static_cast<double>(i + 1) * truth[order[i]];
  return sum_s;
}

TEST(BeliefEdit, AWrongHintCostsNoMoreThanItsFactor) {
  Rng rng{10};
  for (int trial = 0; trial < 300; ++trial) {
    Hall hall;
    std::vector<double> prior(32);
    for (double& probability : prior) probability = std::exp(rng.uniform(-6.0, 0.0));
    const double sum = std::accumulate(prior.begin(), prior.end(), 0.0);
    for (double& probability : prior) probability /= sum;
    hall.belief = SearchBelief(prior);
    const PlanarShape region = Disc{{rng.uniform(0.5, 4.5), rng.uniform(0.5, 2.5)}, rng.uniform(0.1, 2.0)};
    const std::string word(kStrengthWords[static_cast<std::size_t>(trial % 3)].word);
    const double factor = hint_factor(kStrengthWords[static_cast<std::size_t>(trial % 3)].per_s);
    ASSERT_FALSE(hall.edit(trial % 2 == 0 ? Kind::LikelyHere : Kind::NotHere, region, word));
    const auto edited = hall.belief.posterior();
    for (std::size_t i = 0; i < 32; ++i) EXPECT_GE(edited[i], prior[i] / factor * (1.0 - 1e-12)) << trial;
    EXPECT_LE(expected_time_s(edited, prior), factor * expected_time_s(prior, prior)) << trial;
  }
  EXPECT_DOUBLE_EQ(kLargestHintFactor, 10.0);
}

TEST(BeliefEdit, LookingAgainInVainCostsNoMoreThanTheShareThatIsRestored) {
  Rng rng{11};
  for (int trial = 0; trial < 300; ++trial) {
    Hall hall;
    for (int cell = 0; cell < 32; ++cell) hall.belief.look(0, {cell}, 1.0, rng.uniform(0.0, 4.0));
    const auto before = hall.belief.posterior();
    const double left = hall.belief.probability_left();
    const auto mass = hall.belief.mass();
    ASSERT_FALSE(
        hall.edit(Kind::LookAgain, Disc{{rng.uniform(0.5, 4.5), rng.uniform(0.5, 2.5)}, rng.uniform(0.1, 2.0)}));
    auto restored = hall.belief.mass();
    for (std::size_t i = 0; i < 32; ++i) restored[i] -= mass[i];
    // rho / (1 - rho) of the time at which the restored is looked at: rho is restored / (restored + left).
    const double allowance_s = expected_time_s(before, restored) / left;
    EXPECT_LE(expected_time_s(hall.belief.posterior(), before), expected_time_s(before, before) + allowance_s + 1e-9)
        << trial;
  }
}

}  // namespace
}  // namespace tandem
