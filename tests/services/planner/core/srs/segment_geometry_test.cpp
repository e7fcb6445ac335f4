#include "services/planner/core/srs/segment_geometry.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

TEST(SegmentGeometry, SegmentsMeetInAPointOnAnEndOrAlongALine) {
  EXPECT_TRUE(segments_meet({0, 0}, {2, 2}, {0, 2}, {2, 0}));
  EXPECT_TRUE(segments_meet({0, 0}, {2, 0}, {1, 0}, {1, 5}));
  EXPECT_TRUE(segments_meet({0, 0}, {2, 0}, {1, 0}, {5, 0}));
  EXPECT_FALSE(segments_meet({0, 0}, {2, 0}, {3, 0}, {5, 0}));
  EXPECT_FALSE(segments_meet({0, 0}, {2, 0}, {0, 1}, {2, 1}));
}

TEST(SegmentGeometry, ACapsuleIsMetAtItsSidesAndAtItsRoundEnds) {
  std::vector<double> shares;
  append_capsule_crossings({0, 0}, {4, 0}, 1.0, {2, -2}, {2, 2}, shares);
  EXPECT_EQ(shares, (std::vector<double>{0.75, 0.25}));
  shares.clear();
  append_capsule_crossings({0, 0}, {4, 0}, 1.0, {-2, 0}, {6, 0}, shares);
  ASSERT_EQ(shares.size(), 2u);
  EXPECT_DOUBLE_EQ(shares[0] + shares[1], 0.125 + 0.875);
}

TEST(SegmentGeometry, ASmallRootIsNotLostBesideALargeOne) {
  std::vector<double> shares;
  append_quadratic_roots(1.0, -5e3, 1e-4, shares);  // about 1e-8 and 1e4
  ASSERT_EQ(shares.size(), 1u);
  EXPECT_NEAR(shares[0], 1e-8, 1e-18);
}

}  // namespace
}  // namespace tandem
