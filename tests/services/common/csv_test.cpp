#include "services/common/csv.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

TEST(CsvLine, QuotesWhatWouldBreakTheLine) {
  EXPECT_EQ(csv_line({"", "a,b", "say \"x\"", "c"}), ",\"a,b\",\"say \"\"x\"\"\",c\n");
}

}  // namespace
}  // namespace tandem
