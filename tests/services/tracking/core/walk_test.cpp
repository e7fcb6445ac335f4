#include "services/tracking/core/walk.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tandem::tracking {
namespace {

const std::vector<Eigen::Vector2d> kCorner = {{0.0, 0.0}, {3.0, 0.0}, {3.0, 4.0}};

TEST(Walk, GoesAlongThePathFromTheNearestPlace) {
  const Walk walk = walk_along(kCorner, {1.0, 0.0}, 3.0);  // 2 m to the corner, 1 m up
  EXPECT_NEAR((walk.position_in_map - Eigen::Vector2d(3.0, 1.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(walk.direction, Eigen::Vector2d(0.0, 1.0));
}

TEST(Walk, KeepsTheOffsetFromThePath) {
  const Walk walk = walk_along(kCorner, {1.0, -0.5}, 1.0);
  EXPECT_NEAR((walk.position_in_map - Eigen::Vector2d(2.0, -0.5)).norm(), 0.0, 1e-12);
}

TEST(Walk, StandsAtTheEnd) {
  const Walk walk = walk_along(kCorner, {1.0, 0.0}, 100.0);
  EXPECT_EQ(walk.position_in_map, Eigen::Vector2d(3.0, 4.0));
  EXPECT_EQ(walk.direction, Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(walk_along({{1.0, 1.0}}, {1.0, 1.0}, 5.0).position_in_map, Eigen::Vector2d(1.0, 1.0));
}

TEST(Walk, KnowsHowFarAPointIsFromThePath) {
  EXPECT_DOUBLE_EQ(distance_from_path(kCorner, {1.0, 2.0}), 2.0);
  EXPECT_TRUE(std::isinf(distance_from_path({}, {1.0, 2.0})));
}

}  // namespace
}  // namespace tandem::tracking
