#include "services/navigator/core/way_back.hpp"

#include <gtest/gtest.h>

namespace tandem::navigator {
namespace {

TEST(WayBack, LeadsBackAlongTheWayFromTheNewestPoint) {
  WayBack way;
  for (int i = 0; i <= 100; ++i) way.take({0.01 * i, 0.0});
  const auto points = way.points_from({1.5, 0.0});
  ASSERT_EQ(points.size(), 6u);  // here, and one each 0.25 m
  EXPECT_EQ(points.front(), Eigen::Vector2d(1.5, 0.0));
  EXPECT_NEAR(points[1].x(), 1.0, 1e-9);
  EXPECT_NEAR(points.back().x(), 0.0, 1e-9);
}

TEST(WayBack, RemembersTenMetres) {
  WayBack way;
  for (int i = 0; i <= 2000; ++i) way.take({0.01 * i, 0.0});
  EXPECT_NEAR(way.points_from({20.0, 0.0}).back().x(), 10.0, 0.5);
}

}  // namespace
}  // namespace tandem::navigator
