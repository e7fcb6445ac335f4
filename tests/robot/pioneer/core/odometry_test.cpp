#include "robot/pioneer/core/odometry.hpp"

#include <gtest/gtest.h>

namespace tandem::pioneer {
namespace {

constexpr Time kStart{std::chrono::seconds{1000}};
constexpr Duration kCycle = std::chrono::milliseconds{100};

const RobotParameters& millimetres() {
  return *robot_parameters("p3at-sh");
}  // one count is one millimetre

Sip at(int x, int y, int heading) {
  Sip sip;
  sip.x = static_cast<std::uint16_t>(x & 0x7FFF);
  sip.y = static_cast<std::uint16_t>(y & 0x7FFF);
  sip.heading = static_cast<std::int16_t>(heading);
  return sip;
}

Odometry started(std::uint32_t epoch = 5) {
  Odometry odometry{OdometryNoise{}, epoch};
  odometry.restart(millimetres());
  return odometry;
}

TEST(Odometry, TakesTheFirstPacketForAReferenceNotForMotion) {
  Odometry odometry = started();
  EXPECT_EQ(odometry.take(at(12345, 20000, 700), kStart).odom_from_base, Pose2{});
  EXPECT_EQ(odometry.state().epoch, 5u);
}

TEST(Odometry, FollowsStepsInTheControllersFrame) {
  Odometry odometry = started();
  odometry.take(at(0, 0, 1024), kStart);  // the controller faces its own y axis
  const Pose2 pose = odometry.take(at(0, 100, 1024), kStart + kCycle).odom_from_base;
  EXPECT_NEAR(pose.x, 0.1, 1e-9);  // for us that is straight ahead
  EXPECT_NEAR(pose.y, 0.0, 1e-9);
}

TEST(Odometry, WrapsAtFifteenBits) {
  Odometry odometry = started();
  odometry.take(at(0x7FFF - 19, 10, 0), kStart);
  const Pose2 pose = odometry.take(at(0x8000 + 30, 10 - 40, 0), kStart + kCycle).odom_from_base;
  EXPECT_NEAR(pose.x, 0.05, 1e-9);
  EXPECT_NEAR(pose.y, -0.04, 1e-9);
}

TEST(Odometry, ReadsNegativeSixteenBitCountersAsModulo) {
  Odometry odometry = started();
  odometry.take(at(10, 0, 0), kStart);
  Sip sip = at(0, 0, 0);
  sip.x = 0xFFF6;  // -10 in 16 bits: only 15 of them count
  EXPECT_NEAR(odometry.take(sip, kStart + kCycle).odom_from_base.x, -0.02, 1e-9);
}

TEST(Odometry, WrapsTheHeadingInBothHabitsOfRobots) {
  Odometry signed_heading = started();
  signed_heading.take(at(0, 0, 2047), kStart);
  EXPECT_NEAR(signed_heading.take(at(0, 0, -2048), kStart + kCycle).odom_from_base.heading, 2 * std::numbers::pi / 4096,
              1e-12);
  Odometry unsigned_heading = started();
  unsigned_heading.take(at(0, 0, 4095), kStart);
  EXPECT_NEAR(unsigned_heading.take(at(0, 0, 0), kStart + kCycle).odom_from_base.heading, 2 * std::numbers::pi / 4096,
              1e-12);
}

TEST(Odometry, ScalesByTheModel) {
  Odometry odometry{OdometryNoise{}, 1};
  odometry.restart(*robot_parameters("p2at"));
  odometry.take(at(0, 0, 0), kStart);
  EXPECT_NEAR(odometry.take(at(50, 0, 0), kStart + kCycle).odom_from_base.x, 0.066, 1e-9);  // 50 x 1.32 mm
}

TEST(Odometry, CorrectsTheWheels) {
  // Both wheels 2 % larger, and the robot turns on a track that is 2 % wider: it turns as the controller says.
  Odometry odometry{OdometryNoise{}, 1, {.left_wheel_scale = 1.02, .right_wheel_scale = 1.02, .track_scale = 1.02}};
  odometry.restart(millimetres());
  odometry.take(at(0, 0, 0), kStart);
  EXPECT_NEAR(odometry.take(at(100, 0, 0), kStart + kCycle).odom_from_base.x, 0.102, 1e-9);
  EXPECT_NEAR(odometry.take(at(100, 0, 64), kStart + 2 * kCycle).odom_from_base.heading,
              64 * 2 * std::numbers::pi / 4096, 1e-9);
  Sip sip = at(100, 0, 64);
  sip.left_velocity = sip.right_velocity = 100;
  EXPECT_NEAR(odometry.take(sip, kStart + 3 * kCycle).velocity.forward_mps, 1.02 * 100 * millimetres().mps_per_count,
              1e-9);
}

TEST(Odometry, LeavesOutAnImpossibleStepAndGoesOnFromThere) {
  Odometry odometry = started();
  odometry.take(at(0, 0, 0), kStart);
  EXPECT_TRUE(odometry.take(at(3000, 0, 0), kStart + kCycle).jumped);  // 3 m in 0.1 s
  EXPECT_NEAR(odometry.state().odom_from_base.x, 0.0, 1e-9);
  EXPECT_FALSE(odometry.take(at(3050, 0, 0), kStart + 2 * kCycle).jumped);
  EXPECT_NEAR(odometry.state().odom_from_base.x, 0.05, 1e-9);
  EXPECT_EQ(odometry.jumps(), 1u);
}

TEST(Odometry, LosesNoDistanceOverAGapInTheLink) {
  Odometry odometry = started();
  odometry.take(at(0, 0, 0), kStart);
  odometry.take(at(2000, 0, 0), kStart + std::chrono::seconds{4});
  EXPECT_NEAR(odometry.state().odom_from_base.x, 2.0, 1e-9);
}

TEST(Odometry, KeepsThePoseAndBeginsANewEpochAfterAReconnect) {
  Odometry odometry = started();
  odometry.take(at(0, 0, 0), kStart);
  odometry.take(at(100, 0, 0), kStart + kCycle);
  odometry.restart(millimetres());
  odometry.take(at(0, 0, 900), kStart + std::chrono::seconds{3});
  EXPECT_EQ(odometry.state().epoch, 6u);
  EXPECT_NEAR(odometry.state().odom_from_base.x, 0.1, 1e-9);
  EXPECT_EQ(odometry.state().covariance, Covariance3(Covariance3::Zero()));
}

TEST(Odometry, PrefersTheTurnRateOfTheControllerOverThatOfTheWheels) {
  Odometry odometry = started();
  Sip sip = at(0, 0, 0);
  sip.left_velocity = 100;
  sip.right_velocity = 300;
  EXPECT_NEAR(odometry.take(sip, kStart).velocity.forward_mps, 0.2, 1e-9);
  EXPECT_NEAR(odometry.state().velocity.turn_rate_radps, 0.1 * 3.4, 1e-9);
  sip.turn_rate_x10 = 150;
  EXPECT_NEAR(odometry.take(sip, kStart + kCycle).velocity.turn_rate_radps, from_degrees(15.0), 1e-9);
}

double heading_variance_after_a_turn(const char* subclass) {
  Odometry odometry{OdometryNoise{}, 1};
  odometry.restart(*robot_parameters(subclass));
  for (int i = 0; i <= 20; ++i) odometry.take(at(0, 0, 50 * i), kStart + i * kCycle);
  return odometry.state().covariance(2, 2);
}

TEST(Odometry, DoubtsTheHeadingOfASkidSteeredRobotMuchMore) {
  EXPECT_NEAR(heading_variance_after_a_turn("p2at") / heading_variance_after_a_turn("p3dx-sh"), 16.0, 1e-6);
}

TEST(Odometry, GrowsItsDoubtWithTheWay) {
  Odometry odometry = started();
  double last = 0.0;
  for (int i = 0; i < 50; ++i) {
    const auto& state = odometry.take(at(50 * i, 0, 10 * i), kStart + i * kCycle);
    EXPECT_GE(state.covariance.trace(), last);
    last = state.covariance.trace();
    EXPECT_NEAR((state.covariance - state.covariance.transpose()).norm(), 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace tandem::pioneer
