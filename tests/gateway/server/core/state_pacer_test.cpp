#include "gateway/server/core/state_pacer.hpp"

#include <gtest/gtest.h>

namespace tandem::gateway {
namespace {

protocol::State robot_at(double x, double age_s = 0.0) {
  protocol::State state;
  state.robot = protocol::RobotState{{x, 0.0}, 0.0, "ok", age_s};
  return state;
}

Time at(double seconds) {
  return Time{from_seconds(100.0 + seconds)};
}

TEST(StatePacer, SendsAChangeButAtMostTenTimesASecond) {
  StatePacer pacer{from_seconds(0.1), from_seconds(1.0)};
  EXPECT_TRUE(pacer.next(robot_at(0.0), at(0.0)));
  EXPECT_FALSE(pacer.next(robot_at(1.0), at(0.05)));
  EXPECT_TRUE(pacer.next(robot_at(1.0), at(0.1)));
}

TEST(StatePacer, RepeatsWhatDoesNotChangeOnceASecond) {
  StatePacer pacer{from_seconds(0.1), from_seconds(1.0)};
  EXPECT_TRUE(pacer.next(robot_at(0.0), at(0.0)));
  EXPECT_FALSE(pacer.next(robot_at(0.0, 0.5), at(0.5)));  // only older
  EXPECT_FALSE(pacer.next(robot_at(0.001), at(0.6)));     // only noise
  EXPECT_TRUE(pacer.next(robot_at(0.0), at(1.0)));
}

TEST(StatePacer, NumbersWhatItSends) {
  StatePacer pacer{from_seconds(0.1), from_seconds(1.0)};
  EXPECT_EQ(pacer.next(robot_at(0.0), at(0.0))->sequence, 1u);
  EXPECT_EQ(pacer.next(robot_at(1.0), at(1.0))->sequence, 2u);
  EXPECT_EQ(pacer.last()->sequence, 2u);
}

}  // namespace
}  // namespace tandem::gateway
