#include "robot/safety/core/swept_segment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "services/common/pose2.hpp"
#include "services/common/random.hpp"

namespace tandem::safety {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr Hull kHull{0.3, 0.2};

TEST(SweptSegment, AWallAheadIsReachedByTheFront) {
  EXPECT_DOUBLE_EQ(time_to_contact(kHull, 0.0, {0.5, 0.0}, Segment{{1.3, -5.0}, {1.3, 5.0}}), 2.0);
  EXPECT_DOUBLE_EQ(time_to_contact(kHull, 0.1, {0.5, 0.0}, Segment{{1.4, -5.0}, {1.4, 5.0}}), 2.0);
  EXPECT_EQ(time_to_contact(kHull, 0.0, {-0.5, 0.0}, Segment{{1.3, -5.0}, {1.3, 5.0}}), kNever);
  EXPECT_EQ(time_to_contact(kHull, 0.0, {0.5, 0.0}, Segment{{-1.0, 0.3}, {9.0, 0.3}}), kNever);
}

TEST(SweptSegment, ATurnInPlaceTouchesWithItsCorners) {
  const double corner = kHull.corner_radius_m();
  EXPECT_EQ(time_to_contact(kHull, 0.0, {0.0, 1.0}, Segment{{corner + 0.01, -5.0}, {corner + 0.01, 5.0}}), kNever);
  // The front left corner comes to lie straight ahead after turning back by its own bearing.
  const double bearing = std::atan2(0.2, 0.3);
  EXPECT_NEAR(time_to_contact(kHull, 0.0, {0.0, -1.0}, Segment{{corner - 1e-9, -5.0}, {corner - 1e-9, 5.0}}), bearing,
              1e-3);
}

TEST(SweptSegment, AnEdgeInTheMarginCountsOnlyWhileItComesCloser) {
  const Segment beside{{-5.0, 0.25}, {5.0, 0.25}};
  EXPECT_EQ(time_to_contact(kHull, 0.1, {0.5, 0.0}, beside), kNever);
  EXPECT_EQ(time_to_contact(kHull, 0.1, {0.5, 0.5}, beside), 0.0);
  const Segment ahead{{0.35, -5.0}, {0.35, 5.0}};
  EXPECT_EQ(time_to_contact(kHull, 0.1, {0.1, 0.0}, ahead), 0.0);
  EXPECT_EQ(time_to_contact(kHull, 0.1, {-0.1, 0.0}, ahead), kNever);
}

TEST(SweptSegment, WhatLiesInTheHullAllowsNothing) {
  EXPECT_EQ(time_to_contact(kHull, 0.0, {-0.5, 0.0}, Segment{{0.2, -5.0}, {0.2, 5.0}}), 0.0);
  EXPECT_EQ(distance_to_hull(kHull, Segment{{-1.0, 0.1}, {1.0, 0.1}}), 0.0);
  EXPECT_DOUBLE_EQ(distance_to_hull(kHull, Segment{{0.6, 0.6}, {5.0, 0.6}}), 0.5);  // 3-4-5
}

/// The hull driven along its arc in small steps until it overlaps.
double driven_time(const Motion& motion, const Segment& edge, double longest_s) {
  constexpr double kStep_s = 0.001;
  Pose2 start_from_now;
  for (double time_s = 0.0; time_s < longest_s; time_s += kStep_s) {
    const Pose2 now_from_start = inverse(start_from_now);
    if (distance_to_hull(kHull, Segment{now_from_start * edge.from, now_from_start * edge.to}) == 0.0) return time_s;
    start_from_now = start_from_now * Pose2{motion.forward_mps * kStep_s, 0.0, motion.turn_rate_radps * kStep_s};
  }
  return kNever;
}

TEST(SweptSegment, AgreesWithDrivingTheArcInSmallSteps) {
  constexpr std::uint64_t kSeed = 7;
  Rng rng{kSeed};
  int contacts = 0;
  for (int i = 0; i < 2000; ++i) {
    const Motion motion{rng.uniform(-0.5, 0.5), rng.index(4) == 0 ? 0.0 : rng.uniform(-1.0, 1.0)};
    const Eigen::Vector2d from{rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)};
    const Segment edge{from, from + Eigen::Vector2d{rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)}};
    const double exact = time_to_contact(kHull, 0.0, motion, edge);
    const double driven = driven_time(motion, edge, 3.0);
    if (exact > 2.9) continue;
    ++contacts;
    EXPECT_NEAR(driven, exact, 0.02) << "seed " << kSeed << " sample " << i;
  }
  EXPECT_GT(contacts, 500);
}

TEST(SweptSegment, WhoStandsReachesNoEdge) {
  EXPECT_EQ(time_to_contact(kHull, 0.0, {0.0, 0.0}, Segment{{1.3, -5.0}, {1.3, 5.0}}), kNever);
}

TEST(SweptSegment, AnEdgeOfNoLengthIsAPoint) {
  const Segment point{{1.3, 0.1}, {1.3, 0.1}};
  EXPECT_DOUBLE_EQ(distance_to_hull(kHull, point), 1.0);
  EXPECT_DOUBLE_EQ(time_to_contact(kHull, 0.0, {0.5, 0.0}, point), 2.0);
  EXPECT_NEAR(time_to_contact(kHull, 0.0, {0.5, 0.01}, point),
              time_to_contact(kHull, 0.0, {0.5, 0.01}, Eigen::Vector2d{1.3, 0.1}), 1e-9);
}

}  // namespace
}  // namespace tandem::safety
