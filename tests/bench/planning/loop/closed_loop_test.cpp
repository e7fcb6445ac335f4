#include "bench/planning/loop/closed_loop.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "services/planner/core/planners/registry.hpp"

namespace tandem::bench {
namespace {

MakePlanner planner(const std::string& description) {
  return [description] { return make_planner(description); };
}

TEST(ClosedLoop, TheLoopSeesAllOfSmallRooms) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const PlanningInstance instance = instance_of("S0m", seed);
    const LoopResult result = played(instance, planner("tandem"), {.budget = {.rollouts = 5}});
    EXPECT_TRUE(result.finished) << "seed " << seed;
    EXPECT_NEAR(result.score.probability_left, 0.0, 1e-9);
    EXPECT_GT(result.score.expected_time_s, result.sweep_bound_s) << "seed " << seed;
  }
}

TEST(ClosedLoop, EqualSeedsGiveEqualSearches) {
  const PlanningInstance instance = instance_of("S0m", 4);
  const LoopOptions options{.budget = {.rollouts = 20}, .seed = 9};
  const LoopResult once = played(instance, planner("tandem"), options);
  const LoopResult again = played(instance, planner("tandem"), options);
  EXPECT_EQ(once.score.expected_time_s, again.score.expected_time_s);
  EXPECT_EQ(once.duration_s, again.duration_s);
}

TEST(ClosedLoop, NobodyWalksFasterThanTheyCan) {
  const PlanningInstance instance = instance_of("S0m", 2);
  const LoopResult result = played(instance, planner("tandem"), {.budget = {.rollouts = 5}});
  for (std::size_t m = 0; m < result.walked.size(); ++m) {
    const auto& points = result.walked[m].path.points;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double walked_m = (points[i].point_in_map - points[i - 1].point_in_map).norm();
      EXPECT_LE(walked_m, instance.searchers[m].speed_mps * (points[i].time_s - points[i - 1].time_s) + 1e-6);
    }
  }
}

TEST(ClosedLoop, APersonOfTheirOwnWillIsSearchedAround) {
  const PlanningInstance instance = instance_of("S5own", 2);
  LoopOptions options{.budget = {.rollouts = 5}};
  const LoopResult usual = played(instance, planner("tandem"), options);
  EXPECT_TRUE(usual.finished);
  options.person = PersonIs::Known;
  options.person_path = usual.walked[person_of(instance)].path;
  const LoopResult clairvoyant = played(instance, planner("tandem"), options);
  const auto& walked = clairvoyant.walked[person_of(instance)].path;
  // The person walks as it did, whatever the robot does.
  for (double time_s = 0.0; time_s < std::min(walked.duration_s(), options.person_path.duration_s()); time_s += 5.0) {
    EXPECT_NEAR((pose_at(walked, time_s).position() - pose_at(options.person_path, time_s).position()).norm(), 0.0,
                1e-6);
  }
}

TEST(ClosedLoop, AChangingWorldIsSearchedToItsEnd) {
  const LoopResult result = played(instance_of("S6", 3), planner("tandem"), {.budget = {.rollouts = 5}});
  EXPECT_TRUE(result.finished);
  EXPECT_EQ(result.repeated, 0);
}

}  // namespace
}  // namespace tandem::bench
