#include "services/common/format.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

TEST(Format, WritesNumbersAsPrintfDoes) {
  EXPECT_EQ(formatted("%5.2f|%-4d|%s|%+.1e", 1.005, 7, "m", 12345.0), " 1.00|7   |m|+1.2e+04");
  EXPECT_EQ(formatted("%d %%", 95), "95 %");
  EXPECT_EQ(formatted("%s", ""), "");
}

TEST(Format, CutsNoTextOff) {
  const std::string longest(5000, 'x');
  EXPECT_EQ(formatted("<%s>", longest.c_str()), "<" + longest + ">");
}

}  // namespace
}  // namespace tandem
