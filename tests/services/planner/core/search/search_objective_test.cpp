#include "services/planner/core/search/search_objective.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "services/common/random.hpp"

namespace tandem {
namespace {

constexpr double kFirstSight = std::numeric_limits<double>::infinity();

/// Cells that are in view at these times.
Sightings seen(std::initializer_list<std::array<double, 3>> cell_enter_leave) {
  Sightings sightings;
  for (const auto& [cell, enter_s, leave_s] : cell_enter_leave) {
    sightings.cells.push_back(static_cast<std::int32_t>(cell));
    sightings.enter_s.push_back(enter_s);
    sightings.leave_s.push_back(leave_s);
  }
  return sightings;
}

TEST(SearchObjective, T15TheOrderOfRoomsDecidesTheExpectedTime) {
  // Rooms 1 m to the left (p = 0.2) and 3 m to the right (p = 0.8), 1 m/s, seen on arrival.
  SearchObjective objective({{0.2, 0.8}}, 100.0, 100.0);
  const Sightings near_first = seen({{0, 1, 1}, {1, 5, 5}});
  const Sightings likely_first = seen({{1, 3, 3}, {0, 7, 7}});

  EXPECT_NEAR(objective.forecast({{{&near_first, 0.0, kFirstSight}}}).expected_time_s, 4.2, 1e-12);
  EXPECT_NEAR(objective.forecast({{{&likely_first, 0.0, kFirstSight}}}).expected_time_s, 3.8, 1e-12);
}

TEST(SearchObjective, T16TwoAgentsSplitTheRooms) {
  SearchObjective objective({{0.2, 0.8}}, 100.0, 100.0);
  const Sightings left = seen({{0, 1, 1}});
  const Sightings right = seen({{1, 3, 3}});

  const Forecast forecast = objective.forecast({{{&left, 0.0, kFirstSight}, {&right, 0.0, kFirstSight}}});
  EXPECT_NEAR(forecast.expected_time_s, 2.6, 1e-12);
  EXPECT_DOUBLE_EQ(forecast.probability_found, 1.0);
}

TEST(SearchObjective, WhatIsLeftAtTheHorizonCostsTheTail) {
  SearchObjective objective({{0.5, 0.5}}, 10.0, 30.0);
  const Sightings one = seen({{0, 4, 5}, {1, 12, 13}});  // the second too late

  const Forecast forecast = objective.forecast({{{&one, 0.0, kFirstSight}}});
  EXPECT_DOUBLE_EQ(forecast.expected_time_s, 0.5 * 4.0 + 0.5 * 40.0);
  EXPECT_DOUBLE_EQ(forecast.probability_found, 0.5);
}

TEST(SearchObjective, ADetectionRateWorksWhileTheCellIsInView) {
  SearchObjective objective({{1.0}}, 100.0, 50.0);
  const Sightings look = seen({{0, 2, 4}});

  const Forecast forecast = objective.forecast({{{&look, 1.0, 0.5}}});  // from 3 s to 5 s
  const double left = std::exp(-1.0);
  EXPECT_NEAR(forecast.probability_found, 1.0 - left, 1e-12);
  EXPECT_NEAR(forecast.expected_time_s, 3.0 + (1.0 - left) / 0.5 + left * (95.0 + 50.0), 1e-12);
}

TEST(SearchObjective, TwoWhoLookAtOnceDetectAtTheSumOfTheirRates) {
  SearchObjective objective({{1.0}}, 100.0, 50.0);
  const Sightings look = seen({{0, 0, 4}});

  const Forecast two = objective.forecast({{{&look, 0.0, 0.5}, {&look, 0.0, 0.25}}});
  const Forecast one = objective.forecast({{{&look, 0.0, 0.75}}});
  EXPECT_NEAR(two.expected_time_s, one.expected_time_s, 1e-12);
  EXPECT_NEAR(two.probability_found, one.probability_found, 1e-12);
}

TEST(SearchObjective, T14APathInPiecesShowsTheSameAsInOneAndOrderDoesNotMatter) {
  SearchObjective objective({{0.4, 0.6}}, 100.0, 50.0);
  const Sightings whole = seen({{0, 0, 10}, {1, 3, 6}});
  const Sightings first = seen({{0, 0, 5}, {1, 3, 5}});
  const Sightings second = seen({{0, 0, 5}, {1, 0, 1}});

  const double whole_s = objective.forecast({{{&whole, 0.0, 0.1}}}).expected_time_s;
  EXPECT_NEAR(objective.forecast({{{&first, 0.0, 0.1}, {&second, 5.0, 0.1}}}).expected_time_s, whole_s, 1e-12);
  EXPECT_NEAR(objective.forecast({{{&second, 5.0, 0.1}, {&first, 0.0, 0.1}}}).expected_time_s, whole_s, 1e-12);
}

TEST(SearchObjective, AGreatRateIsLikeFirstSight) {
  SearchObjective objective({{0.3, 0.7}}, 100.0, 50.0);
  const Sightings a = seen({{0, 1, 9}, {1, 4, 8}});
  const Sightings b = seen({{1, 2, 3}});
  const Forecast sight = objective.forecast({{{&a, 0.0, kFirstSight}, {&b, 0.0, kFirstSight}}});
  const Forecast rate = objective.forecast({{{&a, 0.0, 1e9}, {&b, 0.0, 1e9}}});
  const Forecast mixed = objective.forecast({{{&a, 0.0, kFirstSight}, {&b, 0.0, 1e9}}});

  EXPECT_NEAR(rate.expected_time_s, sight.expected_time_s, 1e-6);
  EXPECT_NEAR(mixed.expected_time_s, sight.expected_time_s, 1e-6);
}

TEST(SearchObjective, OfTwoObjectsTheLaterFindCounts) {
  // One is surely in cell 0, seen at 10 s, the other in cell 1, seen at 20 s.
  SearchObjective objective({{1.0, 0.0}, {0.0, 1.0}}, 100.0, 50.0);
  const Sightings look = seen({{0, 10, 10}, {1, 20, 20}});

  EXPECT_NEAR(objective.forecast({{{&look, 0.0, kFirstSight}}}).expected_time_s, 20.0, 0.25);
  // Two equal objects, each in either cell: both are found after 10 s with 1/4, else after 20 s.
  SearchObjective equal({{0.5, 0.5}, {0.5, 0.5}}, 100.0, 50.0);
  EXPECT_NEAR(equal.forecast({{{&look, 0.0, kFirstSight}}}).expected_time_s, 0.25 * 10.0 + 0.75 * 20.0, 0.25);
}

/// Looks of two agents at six cells at random.
struct RandomLooks {
  explicit RandomLooks(Rng& rng) {
    for (auto& sightings : both) {
      double time_s = 0.0;
      for (int i = 0; i < 20; ++i) {
        time_s += rng.uniform(0.0, 1.0);
        sightings.cells.push_back(static_cast<std::int32_t>(rng.index(6)));
        sightings.enter_s.push_back(time_s);
        sightings.leave_s.push_back(time_s + rng.uniform(0.0, 2.0));
      }
    }
  }
  std::array<Sightings, 2> both;
};

TEST(SearchObjective, TheSurvivalIntegratesToTheExpectedTime) {
  Rng rng{7};
  const RandomLooks random(rng);
  SearchObjective objective({{0.1, 0.2, 0.1, 0.3, 0.2, 0.1}}, 20.0, 40.0);
  const std::vector<Look> looks{{&random.both[0], 0.0, 0.5}, {&random.both[1], 1.5, 1.0}};
  const Forecast forecast = objective.forecast(looks);
  const auto survival = objective.survival(looks, 0.01);

  double integral_s = 0.0;
  for (std::size_t i = 1; i < survival.size(); ++i) integral_s += 0.005 * (survival[i - 1] + survival[i]);
  EXPECT_NEAR(integral_s + survival.back() * 40.0, forecast.expected_time_s, 1e-3);
  EXPECT_NEAR(1.0 - survival.back(), forecast.probability_found, 1e-12);
}

/// The mean of so many searches, and its standard deviation.
struct PlayedSearches {
  double mean_s = 0.0;
  double sigma_s = 0.0;
};

/// The object lies somewhere by chance, and each look at its cell detects it at a moment of its own, or not at all.
PlayedSearches played(const std::vector<double>& mass, const std::vector<Look>& looks, double horizon_s, double tail_s,
                      Rng& rng) {
  double sum_s = 0.0;
  double sum2 = 0.0;
  constexpr int kSearches = 100'000;
  for (int n = 0; n < kSearches; ++n) {
    int cell = 0;
    for (double u = rng.uniform(); cell + 1 < std::ssize(mass) && u >= mass[static_cast<std::size_t>(cell)]; ++cell) {
      u -= mass[static_cast<std::size_t>(cell)];
    }
    double found_s = horizon_s + tail_s;
    for (const Look& look : looks) {
      for (std::size_t i = 0; i < look.seen->size(); ++i) {
        if (look.seen->cells[i] != cell) continue;
        const double after_s = -std::log(1.0 - rng.uniform()) / look.rate_per_s;
        const double detected_s = look.start_s + look.seen->enter_s[i] + after_s;
        const double end_s = std::min({look.start_s + look.seen->leave_s[i], look.until_s, horizon_s});
        if (detected_s <= end_s) found_s = std::min(found_s, detected_s);
      }
    }
    sum_s += found_s;
    sum2 += found_s * found_s;
  }
  const double mean_s = sum_s / kSearches;
  return {mean_s, std::sqrt((sum2 / kSearches - mean_s * mean_s) / kSearches)};
}

TEST(SearchObjective, T22TheExactExpectedTimeIsTheMeanOfManySearches) {
  // How well the two who look detect: hardly, well, one much better than the other, and at first sight both, one, and
  // the one who comes later.
  constexpr std::array<std::array<double, 2>, 6> kModels{
      {{0.05, 0.05}, {0.5, 1.0}, {5.0, 0.2}, {kFirstSight, kFirstSight}, {kFirstSight, 0.5}, {0.3, kFirstSight}}};
  const std::vector<double> mass{0.1, 0.2, 0.1, 0.3, 0.2, 0.1};
  Rng rng{5};
  for (const auto& rates_per_s : kModels) {
    const RandomLooks random(rng);
    const std::vector<Look> looks{{&random.both[0], 0.0, rates_per_s[0]}, {&random.both[1], 1.5, rates_per_s[1], 9.0}};
    SearchObjective objective({mass}, 15.0, 20.0);
    const PlayedSearches searches = played(mass, looks, 15.0, 20.0, rng);
    EXPECT_NEAR(objective.forecast(looks).expected_time_s, searches.mean_s, 4.0 * searches.sigma_s)
        << "rates " << rates_per_s[0] << " and " << rates_per_s[1];
  }
}

}  // namespace
}  // namespace tandem
