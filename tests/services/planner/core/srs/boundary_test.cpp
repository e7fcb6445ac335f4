#include "services/planner/core/srs/boundary.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

TEST(Boundary, APolygonIsClosed) {
  const Boundary square = Polygon{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}};

  EXPECT_TRUE(contains(square, {2, 1}));
  EXPECT_DOUBLE_EQ(signed_distance(square, {1, 1}), -1.0);
  EXPECT_DOUBLE_EQ(signed_distance(square, {5, 6}), 5.0);  // 3-4-5 from the corner (2, 2)
  EXPECT_EQ(crossings(square, {-1, 1}, {3, 1}), (std::vector<double>{0.25, 0.75}));
}

}  // namespace
}  // namespace tandem
