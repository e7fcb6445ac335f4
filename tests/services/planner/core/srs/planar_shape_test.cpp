#include "services/planner/core/srs/planar_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tandem {
namespace {

std::vector<double> crossings(const PlanarShape& shape, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                              double level_m = 0.0) {
  std::vector<double> shares;
  EXPECT_TRUE(append_level_crossings(shape, level_m, from, to, shares));
  std::sort(shares.begin(), shares.end());
  return shares;
}

TEST(PlanarShape, APolygonIsClosed) {
  const PlanarShape square = Polygon{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}};

  EXPECT_TRUE(contains(square, {2, 1}));
  EXPECT_DOUBLE_EQ(signed_distance(square, {1, 1}), -1.0);
  EXPECT_DOUBLE_EQ(signed_distance(square, {5, 6}), 5.0);  // 3-4-5 from the corner (2, 2)
  EXPECT_EQ(crossings(square, {-1, 1}, {3, 1}), (std::vector<double>{0.25, 0.75}));
}

}  // namespace
}  // namespace tandem
