#include "robot/pioneer/core/gyro.hpp"

#include <gtest/gtest.h>

#include "services/common/angle.hpp"

namespace tandem::pioneer {
namespace {

std::vector<GyroReading> readings(int count, int rate) {
  return std::vector<GyroReading>(static_cast<std::size_t>(count), {static_cast<std::uint16_t>(rate), 30});
}

TEST(Gyro, SaysNothingBeforeItWasAtRestForASecond) {
  Gyro gyro;
  gyro.take(readings(30, 500), true);
  EXPECT_FALSE(gyro.take_turn());
  gyro.take(readings(10, 500), true);
  EXPECT_TRUE(gyro.take_turn());
}

TEST(Gyro, IntegratesWhatIsBelowItsRestCounterClockwise) {
  Gyro gyro;
  gyro.take(readings(40, 510), true);
  static_cast<void>(gyro.take_turn());
  // 5 V / 1023 x 300 deg/s / 2.5 V x 1.626 = 0.9537 deg/s a count: ten counts for a second.
  gyro.take(readings(40, 500), false);
  EXPECT_NEAR(to_degrees(*gyro.take_turn()), 9.537, 0.01);
  gyro.take(readings(40, 520), false);
  EXPECT_NEAR(to_degrees(*gyro.take_turn()), -9.537, 0.01);
  EXPECT_FALSE(gyro.take_turn()) << "nothing came since";
}

TEST(Gyro, FollowsItsRestWhenThatDriftsAndTakesNoPushForRest) {
  Gyro gyro;
  gyro.take(readings(40, 510), true);
  gyro.take(readings(80, 511), true);
  static_cast<void>(gyro.take_turn());
  gyro.take(readings(40, 511), false);
  EXPECT_NEAR(*gyro.take_turn(), 0.0, 1e-9);
  for (int i = 0; i < 40; ++i) gyro.take(readings(1, i % 2 == 0 ? 450 : 560), true);
  static_cast<void>(gyro.take_turn());
  gyro.take(readings(40, 511), false);
  EXPECT_NEAR(*gyro.take_turn(), 0.0, 1e-9);
}

TEST(Gyro, LeavesOutReadingsThatAreNone) {
  Gyro gyro;
  gyro.take(readings(40, 510), true);
  static_cast<void>(gyro.take_turn());
  gyro.take(readings(40, 1023), false);
  gyro.take(readings(40, 0), false);
  EXPECT_FALSE(gyro.take_turn());
}

}  // namespace
}  // namespace tandem::pioneer
