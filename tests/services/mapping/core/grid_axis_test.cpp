#include "services/mapping/core/grid_axis.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

TEST(GridAxis, EntersTheNextCellWhereTheLineCrossesIt) {
  GridAxis axis{2.25, 0.5, 2};  // half a cell forward for each of the line
  EXPECT_DOUBLE_EQ(axis.next, 1.5);
  axis.advance();
  EXPECT_EQ(axis.cell, 3);
  EXPECT_DOUBLE_EQ(axis.next, 3.5);
}

TEST(GridAxis, GoesBackwardsToo) {
  GridAxis axis{2.25, -1.0, 2};
  EXPECT_DOUBLE_EQ(axis.next, 0.25);
  axis.advance();
  EXPECT_EQ(axis.cell, 1);
}

TEST(GridAxis, NeverLeavesItsCellAcross) {
  EXPECT_GT(GridAxis(2.25, 0.0, 2).next, 1e300);
}

}  // namespace
}  // namespace tandem
