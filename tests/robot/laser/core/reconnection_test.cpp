#include "robot/laser/core/reconnection.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

TEST(Reconnection, WaitsLongerAfterEachFailureButNotForEver) {
  Reconnection reconnection;
  for (const int milliseconds : {100, 200, 400, 800, 1000, 1000}) {
    reconnection.failed(false);
    EXPECT_EQ(reconnection.delay(), std::chrono::milliseconds{milliseconds});
  }
  reconnection.succeeded();
  reconnection.failed(false);
  EXPECT_EQ(reconnection.delay(), std::chrono::milliseconds{100});
}

TEST(Reconnection, TriesEveryRateOnASilentPortAndKeepsTheOneThatAnswered) {
  Reconnection reconnection;
  for (const int baud_rate : {115'200, 19'200, 57'600, 250'000, 500'000, 750'000, 115'200}) {
    EXPECT_EQ(reconnection.baud_rate(), baud_rate);
    reconnection.failed(true);
  }
  reconnection.failed(false);
  EXPECT_EQ(reconnection.baud_rate(), 19'200);
}

}  // namespace
}  // namespace tandem
