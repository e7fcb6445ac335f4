#include "bench/planning/loop/walked.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tandem::bench {
namespace {

const TimedPath kEast{{{0.0, {0.0, 0.0}}, {4.0, {4.0, 0.0}}}};

TEST(Walked, APieceOfAPathCountsFromItsBeginning) {
  const TimedPath piece = cut(kEast, 1.0, 3.0);
  ASSERT_EQ(piece.points.size(), 2U);
  EXPECT_DOUBLE_EQ(piece.points[0].point_in_map.x(), 1.0);
  EXPECT_DOUBLE_EQ(piece.points[1].point_in_map.x(), 3.0);
  EXPECT_DOUBLE_EQ(piece.duration_s(), 2.0);
}

TEST(Walked, WhoIsAtTheEndWaits) {
  const TimedPath piece = cut(kEast, 3.0, 6.0);
  EXPECT_DOUBLE_EQ(piece.duration_s(), 3.0);
  EXPECT_DOUBLE_EQ(piece.points.back().point_in_map.x(), 4.0);
  EXPECT_DOUBLE_EQ(length_m(piece), 1.0);
}

TEST(Walked, PiecesJoinToTheWholePath) {
  Walked walked{{0.0, 0.0, 0.0}, {{{0.0, {0.0, 0.0}}}}};
  append(walked, cut(kEast, 0.0, 1.5));
  append(walked, cut(kEast, 1.5, 4.0));
  EXPECT_DOUBLE_EQ(walked.path.duration_s(), 4.0);
  EXPECT_DOUBLE_EQ(length_m(walked.path), 4.0);
  EXPECT_DOUBLE_EQ(pose_at(walked.path, 2.5).x, 2.5);
}

TEST(Walked, WhoDoesNotMoveKeepsTheirHeading) {
  EXPECT_DOUBLE_EQ(pose_after({{{0.0, {1.0, 1.0}}, {2.0, {1.0, 1.0}}}}, {1.0, 1.0, 0.7}).heading, 0.7);
  EXPECT_DOUBLE_EQ(pose_after(kEast, {0.0, 0.0, 0.7}).heading, 0.0);
}

TEST(Walked, SeenIsTakenOffTheMass) {
  const Sightings seen{{0, 1, 2}, {0.0, 1.0, 5.0}, {2.0, 3.0, 6.0}};
  std::vector<double> mass(3, 1.0);
  take_off_seen(mass, seen, 0.5, 2.0);  // the third is seen only after the end
  EXPECT_DOUBLE_EQ(mass[0], std::exp(-1.0));
  EXPECT_DOUBLE_EQ(mass[1], std::exp(-0.5));
  EXPECT_DOUBLE_EQ(mass[2], 1.0);
  take_off_seen(mass, seen, std::numeric_limits<double>::infinity(), 2.0);
  EXPECT_DOUBLE_EQ(mass[0], 0.0);
  EXPECT_DOUBLE_EQ(mass[2], 1.0);
}

TEST(Walked, ParallelPathsLieTheirDistanceApart) {
  const TimedPath beside{{{0.0, {0.0, 3.0}}, {4.0, {4.0, 3.0}}}};
  EXPECT_DOUBLE_EQ(frechet_distance_m(kEast, beside, 4.0), 3.0);
  EXPECT_DOUBLE_EQ(frechet_distance_m(kEast, kEast, 4.0), 0.0);
}

TEST(Walked, WalkingLaterIsNoOtherWay) {
  const TimedPath later{{{0.0, {0.0, 0.0}}, {2.0, {0.0, 0.0}}, {6.0, {4.0, 0.0}}}};
  EXPECT_DOUBLE_EQ(frechet_distance_m(kEast, later, 6.0), 0.0);
}

}  // namespace
}  // namespace tandem::bench
