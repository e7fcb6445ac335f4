#include "services/planner/core/scenario/scenario_search.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace tandem {
namespace {

using Eigen::Vector2d;

const std::vector<Vector2d> kPoints{{0.0, 0.0}, {3.0, 4.0}, {10.0, 0.0}, {20.0, 0.0}};
const std::vector<double> kFloors_m2{1.0, 1.0, 1.0, 1.0};

TEST(ScenarioSearch, APriorIsUniformOverTheFloorIfNothingElseIsSaid) {
  const auto prior = prior_of({}, {0.0, 0.0}, kPoints, {1.0, 1.0, 1.0, 5.0});
  EXPECT_DOUBLE_EQ(prior[0], 0.125);
  EXPECT_DOUBLE_EQ(prior[3], 0.625);
}

TEST(ScenarioSearch, NothingLiesNearTheFirstStart) {
  ScenarioSearch search;
  search.excluded_radius_m = 5.5;  // (3, 4) is 5 m away
  const auto prior = prior_of(search, {0.0, 0.0}, kPoints, kFloors_m2);
  EXPECT_DOUBLE_EQ(prior[0], 0.0);
  EXPECT_DOUBLE_EQ(prior[1], 0.0);
  EXPECT_DOUBLE_EQ(prior[2], 0.5);
  EXPECT_DOUBLE_EQ(prior[3], 0.5);
}

TEST(ScenarioSearch, AnAreaIsSoManyTimesAsLikelyAsTheRest) {
  ScenarioSearch search;
  search.areas.push_back({{{9.0, -1.0}, {11.0, -1.0}, {11.0, 1.0}, {9.0, 1.0}}, 2.0});
  const auto prior = prior_of(search, {0.0, 0.0}, kPoints, kFloors_m2);
  EXPECT_DOUBLE_EQ(prior[2], 0.4);
  EXPECT_DOUBLE_EQ(prior[3], 0.2);
}

TEST(ScenarioSearch, PeaksDrawTheProbabilityToThem) {
  ScenarioSearch search;
  search.peaks.push_back({{10.0, 0.0}, 1.0, 1.0});
  const auto prior = prior_of(search, {0.0, 0.0}, kPoints, kFloors_m2);
  EXPECT_NEAR(prior[2], 1.0, 1e-6);
  EXPECT_NEAR(std::accumulate(prior.begin(), prior.end(), 0.0), 1.0, 1e-12);
}

TEST(ScenarioSearch, APriorThatRulesOutEverythingIsUniform) {
  ScenarioSearch search;
  search.excluded_radius_m = 100.0;
  EXPECT_DOUBLE_EQ(prior_of(search, {0.0, 0.0}, kPoints, kFloors_m2)[1], 0.25);
}

}  // namespace
}  // namespace tandem
