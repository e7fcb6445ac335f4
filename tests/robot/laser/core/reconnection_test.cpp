#include "robot/laser/core/reconnection.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

TEST(Reconnection, WaitsLongerAfterEachFailureButNotForEver) {
  Reconnection reconnection{{115'200}};
  for (const int milliseconds : {100, 200, 400, 800, 1000, 1000}) {
    reconnection.failed(false);
    EXPECT_EQ(reconnection.delay(), std::chrono::milliseconds{milliseconds});
  }
  reconnection.succeeded();
  reconnection.failed(false);
  EXPECT_EQ(reconnection.delay(), std::chrono::milliseconds{100});
}

TEST(Reconnection, TriesEveryRateOnASilentPortAndKeepsTheOneThatAnswered) {
  Reconnection reconnection{{9'600, 38'400, 500'000}};
  for (const int baud_rate : {9'600, 38'400, 500'000, 9'600}) {
    EXPECT_EQ(reconnection.baud_rate(), baud_rate);
    reconnection.failed(true);
  }
  reconnection.failed(false);
  EXPECT_EQ(reconnection.baud_rate(), 38'400);
}

TEST(Reconnection, LooksFirstWhereTheSensorWasSetTo) {
  Reconnection reconnection{{9'600, 38'400, 500'000}};
  reconnection.switched_to(500'000);
  reconnection.failed(false);
  EXPECT_EQ(reconnection.baud_rate(), 500'000);
}

}  // namespace
}  // namespace tandem
