#include "services/cli/plan/labels.hpp"

#include <gtest/gtest.h>

namespace tandem::cli {
namespace {

/// The y of each text, in order.
std::vector<double> heights_in(const std::string& file) {
  std::vector<double> heights;
  for (std::size_t at = 0; (at = file.find("<text ", at)) != std::string::npos; ++at) {
    heights.push_back(std::stod(file.substr(file.find("y=\"", at) + 3)));
  }
  return heights;
}

TEST(Labels, TheSecondAtOnePlaceGoesBelow) {
  Svg svg{100.0, 100.0};
  Labels labels;
  labels.add(svg, {50.0, 50.0}, 5.0, "first", 10.0, "");
  labels.add(svg, {50.0, 50.0}, 5.0, "second", 10.0, "");
  const auto heights = heights_in(svg.file());
  ASSERT_EQ(heights.size(), 2U);
  EXPECT_LT(heights[0], 50.0);
  EXPECT_GT(heights[1], 50.0);
}

TEST(Labels, WhatIsOnlyNiceToHaveIsLeftOutWhereItIsCrowded) {
  Svg svg{100.0, 100.0};
  Labels labels;
  labels.add_if_free(svg, {50.0, 50.0}, "1", 9.0, "");
  labels.add_if_free(svg, {51.0, 50.0}, "2", 9.0, "");
  labels.add_if_free(svg, {80.0, 50.0}, "3", 9.0, "");
  EXPECT_EQ(heights_in(svg.file()).size(), 2U);
}

}  // namespace
}  // namespace tandem::cli
