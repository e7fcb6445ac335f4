#include "services/localization/core/latency_window.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

TEST(LatencyWindow, TellsTheMedianAndTheWorstOfTheLastOnes) {
  LatencyWindow window{5};
  EXPECT_TRUE(window.empty());
  for (const int ms : {900, 10, 50, 30, 20, 40}) window.add(std::chrono::milliseconds{ms});  // the first is forgotten

  EXPECT_EQ(window.quantile(0.5), std::chrono::milliseconds{30});
  EXPECT_EQ(window.quantile(1.0), std::chrono::milliseconds{50});
  EXPECT_EQ(window.quantile(0.0), std::chrono::milliseconds{10});
}

}  // namespace
}  // namespace tandem
