#include "services/localization/core/number_lines.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace tandem {
namespace {

std::string complaint_about(const std::string& text) {
  try {
    (void)number_lines(text, 2, "poses.txt");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(NumberLines, SkipsCommentsAndEmptyLines) {
  const auto lines = number_lines("# time x\n1 2.5\n\n \t\r\n-3e1 4 5\n", 2, "poses.txt");

  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0], (std::vector<double>{1.0, 2.5}));
  EXPECT_EQ(lines[1], (std::vector<double>{-30.0, 4.0, 5.0}));
}

TEST(NumberLines, ALineWithFewerNumbersOrSomethingElseIsNamedByFileAndLine) {
  EXPECT_EQ(complaint_about("1 2\n3\n"), "poses.txt:2: expected 2 numbers");
  EXPECT_EQ(complaint_about("1 2\n# x\n3 four\n"), "poses.txt:3: expected 2 numbers");
  EXPECT_EQ(complaint_about("1 2,5\n"), "poses.txt:1: expected 2 numbers");
}

TEST(NumberLines, WhatIsNotFiniteIsNoNumber) {
  EXPECT_NE(complaint_about("1 nan\n"), "");
  EXPECT_NE(complaint_about("inf 1\n"), "");
}

}  // namespace
}  // namespace tandem
