#include "robot/safety/core/command_monitor.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tandem::safety {
namespace {

using std::chrono::milliseconds;

Time at(int ms) {
  return Time{} + milliseconds{ms};
}

CommandSample command(std::uint8_t commander, std::uint64_t number, double forward_mps) {
  return {.commander = {commander}, .sequence_number = number, .motion = {forward_mps, 0.0}};
}

bool holds(const Causes& causes, Cause cause) {
  return causes.test(index_of(cause));
}

class CommandMonitorTest : public testing::Test {
 protected:
  GateConfig config_;
  CommandMonitor monitor_{config_};
};

TEST_F(CommandMonitorTest, ACommandHoldsUntilItIsStale) {
  monitor_.take(command(1, 1, 0.4), at(0));

  EXPECT_DOUBLE_EQ(monitor_.wanted(at(300)).forward_mps, 0.4);
  EXPECT_FALSE(holds(monitor_.causes(at(300)), Cause::StaleCommand));
  EXPECT_DOUBLE_EQ(monitor_.wanted(at(301)).forward_mps, 0.0);
  EXPECT_TRUE(holds(monitor_.causes(at(301)), Cause::StaleCommand));
}

TEST_F(CommandMonitorTest, SilenceAfterStandStillIsNoFault) {
  monitor_.take(command(1, 1, 0.0), at(0));
  EXPECT_TRUE(monitor_.causes(at(10'000)).none());
}

TEST_F(CommandMonitorTest, ADoubledOrOvertakenCommandIsLeftOut) {
  monitor_.take(command(1, 7, 0.4), at(0));
  monitor_.take(command(1, 6, 0.1), at(50));
  monitor_.take(command(1, 7, 0.1), at(60));
  EXPECT_DOUBLE_EQ(monitor_.wanted(at(100)).forward_mps, 0.4);
}

TEST_F(CommandMonitorTest, NonsenseIsCountedAndTheLastGoodCommandHolds) {
  monitor_.take(command(1, 1, 0.4), at(0));
  monitor_.take(command(1, 2, std::numeric_limits<double>::quiet_NaN()), at(50));
  monitor_.take(command(1, 3, 99.0), at(100));

  EXPECT_EQ(monitor_.rejected(), 2U);
  EXPECT_DOUBLE_EQ(monitor_.wanted(at(150)).forward_mps, 0.4);
  EXPECT_FALSE(holds(monitor_.causes(at(150)), Cause::BadCommand));
}

TEST_F(CommandMonitorTest, MoreThanThreeBadCommandsWithinASecondAreAFault) {
  for (std::uint64_t i = 1; i <= 4; ++i) monitor_.take(command(1, i, 99.0), at(100 * static_cast<int>(i)));

  EXPECT_TRUE(holds(monitor_.causes(at(500)), Cause::BadCommand));
  EXPECT_FALSE(holds(monitor_.causes(at(1200)), Cause::BadCommand));  // the first is older than a second
}

TEST_F(CommandMonitorTest, TwoCommandersAtOnceAreAFaultUntilOneFallsSilent) {
  monitor_.take(command(1, 1, 0.4), at(0));
  monitor_.take(command(2, 1, 0.2), at(100));

  EXPECT_EQ(monitor_.live_commanders(at(200)), 2);
  EXPECT_TRUE(holds(monitor_.causes(at(200)), Cause::TwoCommanders));
  EXPECT_FALSE(holds(monitor_.causes(at(350)), Cause::TwoCommanders));
}

}  // namespace
}  // namespace tandem::safety
