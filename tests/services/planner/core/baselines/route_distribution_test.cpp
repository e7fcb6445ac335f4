#include "services/planner/core/baselines/route_distribution.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tandem {
namespace {

TEST(RouteDistribution, WhatPaysMoreThanExpectedBecomesLikelier) {
  RouteDistribution distribution = uniform_distribution({{1}, {2}});
  descend(distribution, {1.0, 0.0}, 0.1, 1.0);
  // E[f] = 0.5; H + ln q = 0 at the start: q moves by 0.1 * 0.5 * 0.5.
  EXPECT_NEAR(distribution.probabilities[0], 0.525, 1e-12);
  EXPECT_NEAR(distribution.probabilities[1], 0.475, 1e-12);
  EXPECT_EQ(distribution.likeliest(), 0U);
}

TEST(RouteDistribution, ItSettlesAtTheBoltzmannDistributionOfItsTemperature) {
  RouteDistribution distribution = uniform_distribution({{1}, {2}});
  for (int i = 0; i < 2000; ++i) descend(distribution, {1.0, 0.0}, 0.1, 0.5);
  EXPECT_NEAR(distribution.probabilities[0] / distribution.probabilities[1], std::exp(2.0), 1e-6);
}

TEST(RouteDistribution, RoutesAreDrawnAsOftenAsTheyAreLikely) {
  RouteDistribution distribution = uniform_distribution({{1}, {2}});
  distribution.probabilities = {0.2, 0.8};
  Rng rng{3};
  int second = 0;
  for (int i = 0; i < 10'000; ++i) second += distribution.drawn(rng) == 1 ? 1 : 0;
  EXPECT_NEAR(second, 8000, 160);
}

}  // namespace
}  // namespace tandem
