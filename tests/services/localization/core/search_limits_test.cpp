#include "services/localization/core/search_limits.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tandem {
namespace {

TEST(SearchLimits, WithoutAnAreaEverythingIsAsked) {
  const SearchLimits limits;
  EXPECT_TRUE(limits.meets(0, 0, 1));
  EXPECT_TRUE(limits.meets(1'000'000, 1'000'000, 64));
  EXPECT_TRUE(limits.has_heading(std::numbers::pi));
}

TEST(SearchLimits, ABoxThatTouchesTheSquareMeetsIt) {
  // Columns and rows 40 to 60 of 0.1 m.
  const SearchLimits limits{PoseArea{{5.05, 5.05, 0.0}, 1.0, 0.2}, Pose2{}, 0.1};
  EXPECT_TRUE(limits.meets(40, 60, 1));
  EXPECT_FALSE(limits.meets(39, 50, 1));
  EXPECT_FALSE(limits.meets(50, 61, 1));
  EXPECT_TRUE(limits.meets(0, 0, 64));
  EXPECT_FALSE(limits.meets(64, 0, 64));
}

TEST(SearchLimits, TheSquareLiesAlongTheGridWhereverItsOriginIs) {
  const SearchLimits limits{PoseArea{{2.05, 3.05, 0.0}, 0.5, 0.2}, Pose2{3.0, 2.0, 0.0}, 0.1};
  EXPECT_TRUE(limits.meets(50, 50, 1));
  EXPECT_FALSE(limits.meets(20, 30, 1));
}

TEST(SearchLimits, HeadingsAreComparedAroundTheCircle) {
  const SearchLimits limits{PoseArea{{0.0, 0.0, 3.1}, 1.0, 0.2}, Pose2{}, 0.1};
  EXPECT_TRUE(limits.has_heading(-3.1));
  EXPECT_FALSE(limits.has_heading(-2.9));
  EXPECT_TRUE(limits.has_heading(2.95));
}

}  // namespace
}  // namespace tandem
