#include "services/cli/plan/svg.hpp"

#include <gtest/gtest.h>

namespace tandem::cli {
namespace {

TEST(Svg, NumbersHaveTwoDecimalsAtMostAndNoNeedlessOnes) {
  EXPECT_EQ(svg_number(1.0), "1");
  EXPECT_EQ(svg_number(100.0), "100");
  EXPECT_EQ(svg_number(0.5), "0.5");
  EXPECT_EQ(svg_number(2.0 / 3.0), "0.67");
  EXPECT_EQ(svg_number(-0.001), "0");
}

TEST(Svg, WordsMayHoldAnything) {
  EXPECT_EQ(svg_escaped("a<b>&\"c\"\n"), "a&lt;b&gt;&amp;&quot;c&quot; ");
}

TEST(Svg, CellsBecomeFewRectangles) {
  // ##.
  // ##.
  // #.#
  const std::vector<std::string> rows{"##.", "##.", "#.#"};
  const auto is_set = [&](int column, int row) {
    return rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] == '#';
  };
  EXPECT_EQ(svg_cells(3, 3, is_set), "M0 0h2v2h-2zM0 2h1v1h-1zM2 2h1v1h-1z");
  EXPECT_EQ(svg_cells(3, 3, [](int, int) { return false; }), "");
}

TEST(Svg, AFileHoldsItsElementsInOrder) {
  Svg svg{100.0, 50.0};
  svg.begin_group("fill=\"none\"");
  svg.line({0.0, 0.0}, {1.5, 2.0}, "stroke=\"#000\"");
  svg.end_group();
  svg.text({1.0, 2.0}, "a & b", "");
  const std::string file = svg.file();
  EXPECT_TRUE(file.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100\" height=\"50\""));
  EXPECT_NE(file.find("<g fill=\"none\">\n<line x1=\"0\" y1=\"0\" x2=\"1.5\" y2=\"2\" stroke=\"#000\"/>\n</g>\n"
                      "<text x=\"1\" y=\"2\">a &amp; b</text>\n</svg>\n"),
            std::string::npos)
      << file;
}

}  // namespace
}  // namespace tandem::cli
