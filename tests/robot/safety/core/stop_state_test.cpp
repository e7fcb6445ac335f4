#include "robot/safety/core/stop_state.hpp"

#include <gtest/gtest.h>

namespace tandem::safety {
namespace {

Time at(double time_s) {
  return Time{} + from_seconds(time_s);
}

Causes only(Cause cause) {
  return Causes{}.set(index_of(cause));
}

class StopStateTest : public testing::Test {
 protected:
  GateConfig config_;  ///< 3 s healthy, then 2 s of warning
  StopState state_{config_};
};

TEST_F(StopStateTest, MovesWhileNothingEverHappened) {
  state_.step({}, at(0));
  EXPECT_TRUE(state_.may_move(at(0)));
}

TEST_F(StopStateTest, AnAutomaticStopEndsAfterHealthySecondsAndAWarning) {
  state_.step(only(Cause::StaleScan), at(0));
  EXPECT_FALSE(state_.may_move(at(0)));
  state_.step({}, at(1));
  EXPECT_DOUBLE_EQ(state_.resume_in_s(at(1)), 5.0);
  state_.step({}, at(5.9));
  EXPECT_FALSE(state_.may_move(at(5.9)));
  EXPECT_TRUE(state_.may_move(at(6)));
}

TEST_F(StopStateTest, ACauseThatComesBackStartsThePauseAnew) {
  state_.step(only(Cause::StaleScan), at(0));
  state_.step({}, at(1));
  state_.step(only(Cause::StaleScan), at(5));
  state_.step({}, at(5.5));
  EXPECT_FALSE(state_.may_move(at(10.4)));
  EXPECT_TRUE(state_.may_move(at(10.5)));
}

TEST_F(StopStateTest, ALatchedStopWaitsForSomebodyHoweverLongItTakes) {
  state_.step(only(Cause::Bumper), at(0));
  state_.step({}, at(1));
  EXPECT_TRUE(state_.is_latched());
  EXPECT_FALSE(state_.may_move(at(1000)));

  EXPECT_EQ(state_.resume(1.0, at(1000)), "");
  EXPECT_FALSE(state_.may_move(at(1001.9)));  // people are warned first
  EXPECT_TRUE(state_.may_move(at(1002)));
}

TEST_F(StopStateTest, ResumingIsRefusedWithTheReason) {
  EXPECT_EQ(state_.resume(1.0, at(0)), "nothing to resume");
  state_.step(only(Cause::Bumper), at(0));
  EXPECT_EQ(state_.resume(0.9, at(1)), "hold the button longer");
  EXPECT_EQ(state_.resume(1.0, at(1)), rule_of(Cause::Bumper).message);
  EXPECT_TRUE(state_.is_latched());
}

TEST_F(StopStateTest, WhatStopsAtOnceOnlyIsNotRemembered) {
  state_.step(only(Cause::ObstacleAhead), at(0));
  EXPECT_TRUE(state_.may_move(at(0)));
  EXPECT_TRUE(state_.open_causes().none());
}

TEST_F(StopStateTest, AResumeWhileCommandsHaveCeasedWaitsForThem) {
  state_.step(only(Cause::Bumper), at(0));
  state_.step(only(Cause::StaleCommand), at(1));
  EXPECT_EQ(state_.resume(1.0, at(2)), "");
  EXPECT_EQ(state_.resume_in_s(at(2)), 0.0);
  state_.step(only(Cause::StaleCommand), at(9));
  EXPECT_FALSE(state_.may_move(at(100)));
  state_.step({}, at(100));
  EXPECT_FALSE(state_.may_move(at(104.9)));
  EXPECT_TRUE(state_.may_move(at(105)));
}

}  // namespace
}  // namespace tandem::safety
