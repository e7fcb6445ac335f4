#include "services/mapping/core/grid_regions.hpp"

#include <gtest/gtest.h>

#include "tests/support/ascii_map.hpp"

namespace tandem {
namespace {

TEST(GridRegions, AreCellsThatHangTogetherOverTheirSides) {
  const auto regions = regions_of(test::ascii_map({"..#",  //
                                                   "##.",  //
                                                   "?.."}));
  ASSERT_EQ(regions.size(), 5U);  // corners do not join: the lone # and the two others, two free, one unknown
  EXPECT_EQ(regions[0].state, CellState::Unknown);
  EXPECT_EQ(regions[0].cells, 1U);
  EXPECT_EQ(regions[1].state, CellState::Free);
  EXPECT_EQ(regions[1].cells, 3U);
}

TEST(GridRegions, KnowTheirExtentAndTheirBorder) {
  const auto regions = regions_of(test::ascii_map({"###",  //
                                                   "#.#",  //
                                                   "###"}));
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_TRUE(regions[0].at_border);
  EXPECT_EQ(regions[0].free_sides, 4U);
  EXPECT_FALSE(regions[1].at_border);
  EXPECT_EQ(regions[1].lowest, (CellIndex{1, 1}));
  EXPECT_EQ(regions[1].highest, (CellIndex{1, 1}));
  EXPECT_EQ(regions[0].highest, (CellIndex{2, 2}));
}

TEST(GridRegions, AreNoneOfNoCells) {
  EXPECT_TRUE(regions_of(OccupancyGrid{}).empty());
}

}  // namespace
}  // namespace tandem
