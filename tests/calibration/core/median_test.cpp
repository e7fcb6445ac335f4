#include "calibration/core/median.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

TEST(Median, IsTheOneInTheMiddle) {
  EXPECT_DOUBLE_EQ(median({9.0, 1.0, 5.0}), 5.0);
  EXPECT_DOUBLE_EQ(median({7.0}), 7.0);
}

TEST(Median, IsTheUpperOneOfTwo) {
  EXPECT_DOUBLE_EQ(median({4.0, 1.0, 2.0, 3.0}), 3.0);
}

TEST(Median, OfNothingIsZero) {
  EXPECT_DOUBLE_EQ(median({}), 0.0);
}

TEST(Median, DoesNotMindOneThatIsFarOff) {
  EXPECT_DOUBLE_EQ(median({1.0, 2.0, 3.0}), median({1.0, 2.0, 1e9}));
}

}  // namespace
}  // namespace tandem
