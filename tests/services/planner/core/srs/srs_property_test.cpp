// The laws of docs/srs_model.md that a reader can check by hand: T1 to T8, T18, T23, groups; those of random worlds
// are in srs_random_world_test.cpp.
#include <gtest/gtest.h>

#include <cmath>

#include "services/common/random.hpp"
#include "tests/services/planner/support/sources.hpp"

namespace tandem {
namespace {

AgentMove at(double x, double y = 0.0) {
  return stay_at({x, y});
}

TEST(SrsProperty, T1PaysTheInnerRatioOnTheBoundaryAndFadesOutside) {
  RewardSource source = disc_source("s", {0, 0}, 2.0, 3.0);
  source.outside = {RatioShape::Exponential, -1.0, 0.0, 1.0, {}};

  EXPECT_DOUBLE_EQ(rate_at(source, {2, 0}), 3.0);
  EXPECT_NEAR(rate_at(source, {5, 0}), -0.049787, 1e-6);  // -e^-3
}

TEST(SrsProperty, T2CrossingADiscPaysForTheTimeInsideUntilThePoolIsEmpty) {
  Course unlimited{world_of({"a"}, {disc_source("s", {0, 0}, 2.0, 3.0)})};
  EXPECT_NEAR(unlimited.advance({straight_move({-4, 0}, {4, 0})}, 8.0)[0], 12.0, 1e-12);  // 4 s at 3 per s

  Course limited{world_of({"a"}, {disc_source("s", {0, 0}, 2.0, 3.0, 5.0)})};
  EXPECT_NEAR(limited.advance({straight_move({-4, 0}, {4, 0})}, 8.0)[0], 5.0, 1e-12);
  ASSERT_EQ(limited.record().events.size(), 1u);
  EXPECT_NEAR(limited.record().events[0].time_s, 4.0 - 1.0 / 3.0, 1e-12);  // at x = -1/3
}

TEST(SrsProperty, T3SplittingAMoveChangesNothing) {
  // As T2, with an outer ratio that fades, a ramp, and a shape attached to an agent that turns.
  RewardSource fading = disc_source("fading", {1.2, 0.9}, 1.0, 1.0);
  fading.outside = {RatioShape::Exponential, -2.0, 0.0, 0.7, {}};
  RewardSource ramp = disc_source("ramp", {0, 0.3}, 2.0, 0.0, 4.0);
  ramp.inside = {RatioShape::Ramp, 0.0, 3.0, 1.0, {}};
  RewardSource ahead;
  ahead.id = "ahead_of_b";
  ahead.boundary = Attached{"b", Disc{{1.0, 0}, 1.5}};
  ahead.inside = {RatioShape::Exponential, 1.0, 4.0, 0.5, {}};
  const RewardWorld world = world_of({"a", "b"}, {disc_source("s", {0, 0}, 2.0, 3.0, 5.0), fading, ramp, ahead});
  AgentMove turning = straight_move({0, -1}, {0, 1});
  turning.from_heading_rad = 0.0;
  turning.to_heading_rad = 3.0;
  const AgentMove crossing = straight_move({-4, 0}, {4, 0});

  Course whole{world};
  const auto expected = whole.advance({crossing, turning}, 8.0);
  for (const int pieces : {2, 7, 100}) {
    Course course{world};
    double sum_a = 0.0;
    double sum_b = 0.0;
    for (int i = 0; i < pieces; ++i) {
      const double from = static_cast<double>(i) / pieces;
      const double to = static_cast<double>(i + 1) / pieces;
      const auto rewards = course.advance({part_of(crossing, from, to), part_of(turning, from, to)}, 8.0 / pieces);
      sum_a += rewards[0];
      sum_b += rewards[1];
    }
    EXPECT_NEAR(sum_a, expected[0], 1e-9) << pieces;
    EXPECT_NEAR(sum_b, expected[1], 1e-9) << pieces;
  }
}

TEST(SrsProperty, T4TwoAgentsShareAPoolInProportionToTheirRatios) {
  // The ratio is the depth behind the line x = 0 in metres: 3 and 1.
  RewardSource source;
  source.id = "s";
  source.boundary = HalfPlane{{0, 0}, {-1, 0}};
  source.inside = {RatioShape::Ramp, 0.0, 10.0, 10.0, {}};
  source.pool = 8.0;
  Course course{world_of({"a", "b"}, {source})};

  const auto rewards = course.advance({at(3), at(1)}, 5.0);
  EXPECT_NEAR(rewards[0], 6.0, 1e-9);
  EXPECT_NEAR(rewards[1], 2.0, 1e-9);
  ASSERT_EQ(course.record().events.size(), 1u);
  EXPECT_NEAR(course.record().events[0].time_s, 2.0, 1e-9);
}

TEST(SrsProperty, T5ANegativePoolRepelsOnlyUntilItIsEmpty) {
  Course course{world_of({"a"}, {disc_source("s", {0, 0}, 1.0, -2.0, -4.0)})};

  EXPECT_NEAR(course.advance({at(0)}, 5.0)[0], -4.0, 1e-12);
  EXPECT_DOUBLE_EQ(course.advance({at(0)}, 5.0)[0], 0.0);
  EXPECT_DOUBLE_EQ(course.account().left(0), 0.0);
}

TEST(SrsProperty, T6TheDoorPaysOnlyAfterTheKey) {
  const RewardWorld world =
      world_of({"a"}, {disc_source("key", {2, 0}, 0.1, 1e6, 1.0), disc_source("door", {-2, 0}, 0.1, 1e7, 10.0)},
               {strict("key", "door")});
  Course key_first{world};
  double sum = key_first.advance({straight_move({0, 0}, {2, 0})}, 2.0)[0];
  sum += key_first.advance({straight_move({2, 0}, {-2, 0})}, 4.0)[0];
  EXPECT_NEAR(sum, 11.0, 1e-9);  // at 6 s

  Course door_first{world};
  EXPECT_DOUBLE_EQ(door_first.advance({straight_move({0, 0}, {-2, 0})}, 2.0)[0], 0.0);
}

TEST(SrsProperty, T7AProductPaysOnlyBeforeTheCashierAndTheExitOnlyAfter) {
  const RewardWorld world =
      world_of({"a"},
               {disc_source("product", {0, 0}, 1.0, 1.0, 2.0), disc_source("cashier", {9, 0}, 1.0, 1.0, 2.0),
                disc_source("exit", {18, 0}, 1.0, 1.0, 2.0)},
               {soft("product", "cashier"), strict("cashier", "exit")});
  Course all{world};
  EXPECT_NEAR(all.advance({at(0)}, 2.0)[0] + all.advance({at(9)}, 2.0)[0] + all.advance({at(18)}, 2.0)[0], 6.0, 1e-12);

  Course without_product{world};
  EXPECT_DOUBLE_EQ(without_product.advance({at(18)}, 3.0)[0], 0.0);   // not paid yet
  EXPECT_NEAR(without_product.advance({at(9)}, 3.0)[0], 2.0, 1e-12);  // skipping the product is legal
  EXPECT_DOUBLE_EQ(without_product.advance({at(0)}, 3.0)[0], 0.0);    // too late
  EXPECT_NEAR(without_product.advance({at(18)}, 3.0)[0], 2.0, 1e-12);
}

TEST(SrsProperty, T8CodependentPoolsEmptyTogether) {
  Course cashiers{
      world_of({"a"},
               {disc_source("one", {0, 0}, 1.0, 1.0, 5.0), disc_source("two", {5, 0}, 1.0, 1.0, 5.0),
                disc_source("three", {10, 0}, 1.0, 1.0, 5.0)},
               {codependent("one", "two", 1.0), codependent("two", "three", 1.0), codependent("one", "three", 1.0)})};
  EXPECT_NEAR(
      cashiers.advance({at(0)}, 2.0)[0] + cashiers.advance({at(5)}, 9.0)[0] + cashiers.advance({at(10)}, 9.0)[0], 5.0,
      1e-12);

  Course pair{world_of({"a"}, {disc_source("one", {0, 0}, 1.0, 10.0, 10.0), disc_source("other", {9, 0}, 1, 10, 10)},
                       {codependent("one", "other", 0.4)})};
  EXPECT_NEAR(pair.advance({at(0)}, 1.0)[0], 10.0, 1e-12);
  EXPECT_NEAR(pair.account().left(1), 6.0, 1e-12);
}

TEST(SrsProperty, T18AHazardStillHurtsAnAgentThatWaits) {
  RewardSource smoke = disc_source("smoke", {0, 0}, 3.0, -0.5);
  smoke.kind = SourceKind::Environment;
  Course course{world_of({"waits", "walks"}, {smoke})};

  const auto rewards = course.advance({at(1), straight_move({5, 0}, {9, 0})}, 4.0);
  EXPECT_DOUBLE_EQ(rewards[0], -2.0);
  EXPECT_DOUBLE_EQ(rewards[1], 0.0);
}

TEST(SrsProperty, T23WhatWasConsumedStaysConsumedAfterAnEdit) {
  const RewardWorld before = world_of(
      {"a"}, {disc_source("key", {0, 0}, 1, 1, 1), disc_source("door", {5, 0}, 1, 1, 4)}, {strict("key", "door")});
  RewardWorld after = before;
  ASSERT_FALSE(add_source(after, disc_source("other", {9, 0}, 1, 1, 1)));
  Course course{before};
  course.advance({at(0)}, 1.0);
  course.advance({at(5)}, 1.0);

  const ResolvedWorld ready{after};
  Course fresh{after};
  fresh.account().restore(carried_over(course.account().state(), course.account().world(), ready));
  EXPECT_DOUBLE_EQ(fresh.advance({at(0)}, 1.0)[0], 0.0);
  EXPECT_DOUBLE_EQ(fresh.advance({at(5)}, 9.0)[0], 3.0);
  EXPECT_DOUBLE_EQ(fresh.advance({at(9)}, 9.0)[0], 1.0);
}

TEST(SrsProperty, OverlappingPartsOfOneObjectCountOnceInAGroup) {
  // A table of two discs that overlap between x = -1 and x = 1; it repels.
  RewardWorld table = world_of({"a"}, {disc_source("left", {-1, 0}, 2, -1), disc_source("right", {1, 0}, 2, -1)});
  const std::vector<AgentMove> across{straight_move({-3, 0}, {3, 0})};  // 2 s in each alone, 2 s in both
  EXPECT_NEAR((Course{table}.advance(across, 6.0)[0]), -8.0, 1e-12);
  table.groups = {{"table", {"left", "right"}, std::numeric_limits<double>::infinity()}};
  EXPECT_NEAR((Course{table}.advance(across, 6.0)[0]), -6.0, 1e-12);
}

TEST(SrsProperty, ManySourcesOfAGroupPayLikeTheOneTheyMake) {
  // Four squares in a row, or the rectangle of them.
  RewardWorld many = world_of({"a", "b"}, {});
  SourceGroup group{"row", {}, 5.0};
  for (int i = 0; i < 4; ++i) {
    RewardSource square = disc_source("square" + std::to_string(i), {0, 0}, 1, 2.0);
    square.boundary = Polygon{{{i, 0}, {i + 1, 0}, {i + 1, 1}, {i, 1}}};
    many.sources.push_back(square);
    group.members.push_back(square.id);
  }
  many.groups = {group};
  RewardSource rectangle = disc_source("rectangle", {0, 0}, 1, 2.0, 5.0);
  rectangle.boundary = Polygon{{{0, 0}, {4, 0}, {4, 1}, {0, 1}}};
  const RewardWorld one = world_of({"a", "b"}, {rectangle});
  Rng rng{9};
  for (int i = 0; i < 50; ++i) {
    const auto any = [&] { return Eigen::Vector2d{rng.uniform(-1, 5), rng.uniform(-1, 2)}; };
    const std::vector<AgentMove> moves{straight_move(any(), any()), straight_move(any(), any())};
    const auto expected = Course{one}.advance(moves, 4.0);
    const auto got = Course{many}.advance(moves, 4.0);
    for (std::size_t agent = 0; agent < 2; ++agent) EXPECT_NEAR(got[agent], expected[agent], 1e-9) << i;
  }
}

}  // namespace
}  // namespace tandem
