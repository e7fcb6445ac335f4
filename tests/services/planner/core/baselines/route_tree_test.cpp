#include "services/planner/core/baselines/route_tree.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

/// Routes of three places out of {0, 1}; the reward counts the ones.
std::vector<int> two_ways(const std::vector<int>& route) {
  return route.size() < 3 ? std::vector<int>{0, 1} : std::vector<int>{};
}

double ones(const std::vector<int>& route) {
  double sum = 0.0;
  for (const int place : route) sum += place;
  return sum / 3.0;
}

TEST(RouteTree, LearnsWhichRoutePaysMost) {
  RouteTree tree({});
  Rng rng{1};
  const auto simulate = [&](std::vector<int>& route) {
    while (route.size() < 3) route.push_back(static_cast<int>(rng.index(2)));
    return ones(route);
  };
  for (int i = 0; i < 200; ++i) tree.grow(two_ways, simulate, rng);
  EXPECT_EQ(tree.size(), 15U);  // 1 + 2 + 4 + 8
  EXPECT_EQ(tree.best_routes(1), (std::vector<std::vector<int>>{{1, 1, 1}}));
  EXPECT_EQ(tree.best_routes(100).size(), 8U);  // each once
}

TEST(RouteTree, ForgetsWhatNoLongerPays) {
  RouteTree tree({.exploration = 0.35, .discount = 0.9});
  Rng rng{1};
  for (int i = 0; i < 100; ++i) tree.grow(two_ways, ones, rng);
  const auto zeros = [](std::vector<int>& route) { return 1.0 - ones(route); };
  for (int i = 0; i < 200; ++i) tree.grow(two_ways, zeros, rng);
  EXPECT_EQ(tree.best_routes(1).front().front(), 0);
}

}  // namespace
}  // namespace tandem
