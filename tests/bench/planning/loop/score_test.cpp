#include "bench/planning/loop/score.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "bench/planning/instance/floor_plan.hpp"

namespace tandem::bench {
namespace {

/// A corridor of 20 cells of 1 m; who walks it sees 2 cells ahead (2.1 m: not a question of rounding).
class ScoreInACorridor : public testing::Test {
 protected:
  static SearchWorldOptions options() {
    SearchWorldOptions options;
    options.area = {1.0, 0.25, {0.5, 0.5}, {}};
    Searcher walker{.id = "walker", .speed_mps = 1.0, .radius_m = 0.3, .view_max_m = 2.1};
    walker.detection_rate_per_s = std::numeric_limits<double>::infinity();
    options.searchers = {walker, walker};
    return options;
  }
  SearchWorld world_{{drawn({20.0, 1.0, 0.1, {}}, 0.0)}, options()};
  std::vector<double> prior_ = std::vector<double>(20, 0.05);
  Walked goes_ = {{0.5, 0.5, 0.0}, {{{0.0, {0.5, 0.5}}, {19.0, {19.5, 0.5}}}}};
  Walked stays_ = {{0.5, 0.5, 0.0}, {{{0.0, {0.5, 0.5}}, {19.0, {0.5, 0.5}}}}};
};

TEST_F(ScoreInACorridor, AddsUpTheTimesOfFirstSight) {
  // Cells 0 to 2 at once; cell k from the moment cell k - 2 is entered, at k - 2.5 s: 0.05 * (0.5 + ... + 16.5).
  const SearchScore score = score_of(world_, prior_, {goes_, stays_}, 100.0);
  EXPECT_NEAR(score.expected_time_s, 0.05 * 0.5 * 17.0 * 17.0, 1e-9);
  EXPECT_NEAR(score.probability_left, 0.0, 1e-12);
  EXPECT_NEAR(score.found95_s, 16.0, 0.51);
  EXPECT_DOUBLE_EQ(score.distance_m[0], 19.0);
  EXPECT_DOUBLE_EQ(score.distance_m[1], 0.0);
}

TEST_F(ScoreInACorridor, WhatIsLeftIsFoundOneSweepAfterTheHorizon) {
  const SearchScore score = score_of(world_, prior_, {stays_, stays_}, 100.0);
  // 17 of 20 cells are never seen; two walkers sweep 2 * 2.1 m * 1 m/s each: 20 m2 in 2.38 s.
  EXPECT_NEAR(score.expected_time_s, 0.85 * (100.0 + world_.sweep_time_s({0, 1})), 1e-9);
  EXPECT_NEAR(world_.sweep_time_s({0, 1}), 20.0 / 8.4, 0.01);
}

TEST_F(ScoreInACorridor, WhoSeesTheSameTwiceOverlaps) {
  EXPECT_NEAR(score_of(world_, prior_, {goes_, goes_}, 100.0).overlap, 1.0, 1e-9);
  EXPECT_NEAR(score_of(world_, prior_, {goes_, stays_}, 100.0).overlap, 3.0 / 20.0, 1e-9);
}

}  // namespace
}  // namespace tandem::bench
