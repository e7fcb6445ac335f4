#include "bench/planning/report/plot.hpp"

#include <gtest/gtest.h>

namespace tandem::bench {
namespace {

TEST(Plot, TicksAreRound) {
  EXPECT_EQ(round_ticks(0.0, 10.0, 5), (std::vector<double>{0.0, 2.0, 4.0, 6.0, 8.0, 10.0}));
  EXPECT_EQ(round_ticks(95.0, 121.0, 3), (std::vector<double>{100.0, 110.0, 120.0}));
}

TEST(Plot, TheCornersOfALineLieInTheCornersOfThePlot) {
  const std::string svg =
      plotted({{"line", {{0.0, 0.0}, {10.0, 5.0}}}}, {.title = "t", .x_label = "x", .y_label = "y"});
  EXPECT_NE(svg.find("points=\"70.0,350.0 470.0,40.0 \""), std::string::npos);
}

TEST(Plot, OnALogarithmicAxisADecadeIsAsLongAsTheNext) {
  const std::string svg = plotted({{"line", {{1.0, 0.0}, {10.0, 1.0}, {100.0, 2.0}}}},
                                  {.title = "t", .x_label = "x", .y_label = "y", .x_logarithmic = true});
  EXPECT_NE(svg.find("points=\"70.0,350.0 270.0,195.0 470.0,40.0 \""), std::string::npos);
}

TEST(Plot, NamesAreEscaped) {
  const std::string svg = plotted({{"a<b&c", {{0.0, 0.0}}}}, {.title = "t", .x_label = "x", .y_label = "y"});
  EXPECT_NE(svg.find("a&lt;b&amp;c"), std::string::npos);
}

}  // namespace
}  // namespace tandem::bench
