#include "services/navigator/core/path.hpp"

#include <gtest/gtest.h>

namespace tandem::navigator {
namespace {

const Path kCorner{{{0.0, 0.0}, {3.0, 0.0}, {3.0, 4.0}}};

TEST(Path, MeasuresTheWayFromItsStart) {
  EXPECT_DOUBLE_EQ(kCorner.length_m(), 7.0);
  EXPECT_EQ(kCorner.point_at(1.0), Eigen::Vector2d(1.0, 0.0));
  EXPECT_EQ(kCorner.point_at(5.0), Eigen::Vector2d(3.0, 2.0));
  EXPECT_EQ(kCorner.point_at(-1.0), Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(kCorner.point_at(9.0), Eigen::Vector2d(3.0, 4.0));
}

TEST(Path, FindsTheNearestPlaceWithinTheGivenWay) {
  const Path::Place place = kCorner.nearest({2.0, 1.5}, 0.0, 7.0);
  EXPECT_DOUBLE_EQ(place.way_m, 4.5);  // 1 m from the second piece, 1.5 m from the first
  EXPECT_DOUBLE_EQ(place.distance_m, 1.0);
  EXPECT_DOUBLE_EQ(kCorner.nearest({2.0, 1.5}, 0.0, 3.0).way_m, 2.0);
  EXPECT_DOUBLE_EQ(kCorner.nearest({0.0, 0.0}, 1.0, 3.0).way_m, 1.0);
}

TEST(Path, WhereItComesByTwiceTheEarlierTimeCounts) {
  const Path there_and_back{{{0.0, 0.0}, {5.0, 0.0}, {0.0, 0.0}}};
  EXPECT_DOUBLE_EQ(there_and_back.nearest({1.0, 0.0}, 0.0, 10.0, 0.05).way_m, 1.0);
}

TEST(Path, OfOnePlaceHasNoLength) {
  const Path standing{{{1.0, 2.0}, {1.0, 2.0}}};
  EXPECT_DOUBLE_EQ(standing.length_m(), 0.0);
  EXPECT_EQ(standing.point_at(1.0), Eigen::Vector2d(1.0, 2.0));
  EXPECT_DOUBLE_EQ(standing.nearest({4.0, 6.0}, 0.0, 5.0).distance_m, 5.0);
}

}  // namespace
}  // namespace tandem::navigator
