#include "robot/safety/core/motion_monitor.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tandem::safety {
namespace {

using std::chrono::milliseconds;

BaseInput healthy() {
  BaseInput base;
  base.connected = true;
  base.motors_enabled = true;
  base.battery_v = 12.5;
  return base;
}

class MotionMonitorTest : public testing::Test {
 protected:
  /// One cycle of 50 ms.
  Causes step(const BaseInput& base, const Motion& commanded = {}) {
    now_ += milliseconds{50};
    return monitor_.step(base, commanded, now_);
  }
  bool holds(const BaseInput& base, Cause cause, const Motion& commanded = {}) {
    return step(base, commanded).test(index_of(cause));
  }

  GateConfig config_;
  MotionMonitor monitor_{config_};
  Time now_{};
};

TEST_F(MotionMonitorTest, AHealthyBaseIsNoCause) {
  EXPECT_TRUE(step(healthy()).none());
}

TEST_F(MotionMonitorTest, ABaseIsNotThereBeforeItAnsweredAndLostAfterwards) {
  EXPECT_TRUE(holds({}, Cause::BaseNotThere));
  step(healthy());
  EXPECT_TRUE(holds({}, Cause::BaseLost));
}

TEST_F(MotionMonitorTest, BumpersStallAndEmergencyStopCountAtOnce) {
  BaseInput base = healthy();
  base.rear_bumpers = 2;
  base.left_stalled = true;
  base.estop_pressed = true;
  const Causes causes = step(base);
  EXPECT_TRUE(causes.test(index_of(Cause::Bumper)));
  EXPECT_TRUE(causes.test(index_of(Cause::Stall)));
  EXPECT_TRUE(causes.test(index_of(Cause::EmergencyStop)));
}

TEST_F(MotionMonitorTest, AStepOfMoreThanHalfAMetreIsAJumpUnlessOdometryBeganAnew) {
  BaseInput base = healthy();
  step(base);
  base.odom_from_base = {3.0, 4.0, 0.0};
  EXPECT_TRUE(holds(base, Cause::OdometryJump));
  base.odom_from_base = {0.0, 0.0, 0.0};
  base.odometry_epoch = 1;
  EXPECT_FALSE(holds(base, Cause::OdometryJump));
}

TEST_F(MotionMonitorTest, WheelsThatStandStillForLongWhenToldToTurnAreDead) {
  const Motion ahead{0.3, 0.0};
  bool dead = false;
  for (int i = 0; i <= 18; ++i) dead = holds(healthy(), Cause::EncoderDead, ahead);
  EXPECT_FALSE(dead);  // 0.9 s exactly
  EXPECT_TRUE(holds(healthy(), Cause::EncoderDead, ahead));
  BaseInput moving = healthy();
  moving.odom_from_base.x = 0.03;
  EXPECT_FALSE(holds(moving, Cause::EncoderDead, ahead));
}

TEST_F(MotionMonitorTest, AReportThatRepeatsItselfIsDeadWhateverSpeedItTells) {
  for (const Motion& told : {Motion{0.3, 0.0}, Motion{0.0, 0.5}}) {
    BaseInput stuck = healthy();
    stuck.measured = told;
    bool dead = false;
    for (int i = 0; i <= 22; ++i) dead = holds(stuck, Cause::EncoderDead, told);
    EXPECT_TRUE(dead);
    EXPECT_FALSE(holds(stuck, Cause::EncoderDead, {}));
  }
}

TEST_F(MotionMonitorTest, OverspeedCountsOnceItLasts) {
  BaseInput fast = healthy();
  fast.measured.forward_mps = 1.6 * config_.max_speed_mps;
  for (int i = 0; i <= 4; ++i) EXPECT_FALSE(holds(fast, Cause::Overspeed)) << i;  // up to 0.2 s
  EXPECT_TRUE(holds(fast, Cause::Overspeed));
}

TEST_F(MotionMonitorTest, CountsHowFarItHasGoneBackwards) {
  BaseInput base = healthy();
  step(base);
  base.odom_from_base.x = -0.3;
  step(base);
  EXPECT_NEAR(monitor_.reversed_m(), 0.3, 1e-12);
  base.odom_from_base.x = -0.1;
  step(base);
  EXPECT_NEAR(monitor_.reversed_m(), 0.1, 1e-12);
}

TEST_F(MotionMonitorTest, OneLowReadingIsNotAnEmptyBattery) {
  step(healthy());
  BaseInput low = healthy();
  low.battery_v = 10.0;
  EXPECT_FALSE(holds(low, Cause::LowBattery));
  for (int i = 0; i < 200; ++i) step(low);  // 10 s
  EXPECT_TRUE(holds(low, Cause::LowBattery));
}

TEST_F(MotionMonitorTest, EitherWheelThatIsBlockedIsAStallAndEitherBumperAContact) {
  BaseInput base = healthy();
  base.right_stalled = true;
  base.front_bumpers = 1;
  const Causes causes = step(base);
  EXPECT_TRUE(causes.test(index_of(Cause::Stall)));
  EXPECT_TRUE(causes.test(index_of(Cause::Bumper)));
}

TEST_F(MotionMonitorTest, AStepThatTheDriverRejectedOrThatIsNoPlaceIsAJump) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BaseInput rejected = healthy();
  rejected.odometry_jumped = true;
  EXPECT_TRUE(holds(rejected, Cause::OdometryJump));
  for (const Pose2& nowhere : {Pose2{nan, 0.0, 0.0}, Pose2{0.0, nan, 0.0}, Pose2{0.0, 0.0, nan}}) {
    BaseInput base = healthy();
    base.odom_from_base = nowhere;
    EXPECT_TRUE(holds(base, Cause::OdometryJump));
  }
}

TEST_F(MotionMonitorTest, WheelsThatTurnTheRobotInPlaceAreAlive) {
  const Motion turn{0.0, 0.5};
  BaseInput base = healthy();
  bool dead = false;
  for (int i = 0; i <= 40; ++i) {
    base.odom_from_base.heading = 0.025 * i;
    dead = dead || holds(base, Cause::EncoderDead, turn);
  }
  EXPECT_FALSE(dead);
  base.motors_enabled = false;
  for (int i = 0; i <= 40; ++i) dead = dead || holds(base, Cause::EncoderDead, turn);
  EXPECT_FALSE(dead) << "without motors nothing is told";
}

TEST_F(MotionMonitorTest, AVoltageThatIsNotKnownIsNoEmptyBattery) {
  BaseInput base = healthy();
  base.battery_v = 0.0;
  for (int i = 0; i < 200; ++i) EXPECT_FALSE(holds(base, Cause::LowBattery));
  EXPECT_FALSE(monitor_.battery_v());
}

}  // namespace
}  // namespace tandem::safety
