#include "services/simulator/core/pioneer_firmware.hpp"

#include <gtest/gtest.h>

#include "robot/pioneer/core/config_packet.hpp"
#include "tests/services/simulator/core/controller_on_blocks.hpp"

namespace tandem::simulator {
namespace {

using pioneer::Bytes;
using pioneer::Command;
using pioneer::command;

pioneer::Packet only_packet(const Bytes& bytes) {
  pioneer::PacketReceiver receiver;
  receiver.push(bytes, Time{});
  const auto packet = receiver.next();
  EXPECT_TRUE(packet);
  EXPECT_FALSE(receiver.next());
  return packet.value_or(pioneer::Packet{});
}

TEST(PioneerFirmware, AnswersTheHandshakeWithItsIdentity) {
  OnBlocks robot;
  EXPECT_EQ(robot.send({0xFA, 0xFB, 3, 0, 0, 0}), (Bytes{0xFA, 0xFB, 3, 0, 0, 0}));
  EXPECT_EQ(robot.send({0xFA, 0xFB, 3, 1, 0, 1}), (Bytes{0xFA, 0xFB, 3, 1, 0, 1}));
  const auto identity = pioneer::decode_identity(only_packet(robot.send({0xFA, 0xFB, 3, 2, 0, 2})));
  ASSERT_TRUE(identity);
  EXPECT_EQ(identity->robot_class, "Pioneer");
  EXPECT_EQ(identity->subclass, "p2at");
  EXPECT_FALSE(robot.firmware.is_open());
  EXPECT_TRUE(robot.send({0xFA, 0xFB, 3, 1, 0, 1}).empty());
  EXPECT_TRUE(robot.firmware.is_open());
}

TEST(PioneerFirmware, SkipsGarbageAndModemWakeUpBeforeTheFirstSync) {
  OnBlocks robot;
  EXPECT_TRUE(robot.send({'W', 'M', 'S', '2', '\r', 0xFA, 0x00, 0xFB}).empty());
  EXPECT_EQ(only_packet(robot.send(command(Command::Pulse))).number, pioneer::packet_type::kSync0);
}

TEST(PioneerFirmware, OpensWithAnArgumentToo) {
  OnBlocks robot;
  for (const auto sync : {Command::Pulse, Command::Open, Command::Close}) (void)robot.send(command(sync));
  (void)robot.send(command(Command::Open, 1));
  EXPECT_TRUE(robot.firmware.is_open());
  (void)robot.send(command(Command::Close, 1));
  EXPECT_FALSE(robot.firmware.is_open());
}

TEST(PioneerFirmware, SaysThatItsSyncCounterIsOff) {
  OnBlocks robot;
  EXPECT_EQ(only_packet(robot.send(command(Command::Close))).number, pioneer::packet_type::kSyncCounterOff);
}

TEST(PioneerFirmware, MovesOnlyWithMotorsOn) {
  OnBlocks robot;
  robot.open();
  (void)robot.send(command(Command::Velocity, 300));
  robot.run(1.0, true);
  EXPECT_EQ(robot.firmware.speed(), BodySpeed{});
  EXPECT_FALSE(robot.sip().motors_enabled());
  (void)robot.send(command(Command::Enable, 1));
  robot.run(2.0, true);
  EXPECT_DOUBLE_EQ(robot.firmware.speed().forward_mps, 0.3);
  EXPECT_TRUE(robot.sip().motors_enabled());
}

TEST(PioneerFirmware, PassesTheDriveCheckOfOthers) {  // 0.3 m/s for 2 s with ramps of 300 mm/s^2
  OnBlocks robot;
  robot.open();
  (void)robot.send(command(Command::Enable, 1));
  (void)robot.send(command(Command::Velocity, 300));
  robot.run(2.0, true);
  (void)robot.send(command(Command::Stop));
  robot.run(1.5, true);
  EXPECT_EQ(robot.firmware.speed(), BodySpeed{});
  EXPECT_NEAR(robot.firmware.odom_from_base().x, 0.6, 0.02);  // 0.15 up, 0.3, 0.15 down
  EXPECT_NEAR(robot.sip().x * 0.00132, 0.6, 0.02);
}

TEST(PioneerFirmware, WatchdogStopsTheWheels) {
  OnBlocks robot;
  robot.open();
  (void)robot.send(command(Command::Enable, 1));
  (void)robot.send(command(Command::Velocity, 300));
  robot.run(1.5, true);
  ASSERT_DOUBLE_EQ(robot.firmware.speed().forward_mps, 0.3);
  robot.run(0.5, false);
  EXPECT_DOUBLE_EQ(robot.firmware.speed().forward_mps, 0.3);  // 500 ms are not over
  robot.run(1.1, false);
  EXPECT_EQ(robot.firmware.speed(), BodySpeed{});
}

TEST(PioneerFirmware, RevivesAtTheLastSpeedWhenPacketsComeBack) {
  OnBlocks robot;
  robot.open();
  (void)robot.send(command(Command::Enable, 1));
  (void)robot.send(command(Command::Velocity, 300));
  robot.run(1.5, true);
  robot.run(2.0, false);
  ASSERT_EQ(robot.firmware.speed(), BodySpeed{});
  robot.run(1.5, true);  // nothing but PULSE
  EXPECT_DOUBLE_EQ(robot.firmware.speed().forward_mps, 0.3);
}

TEST(PioneerFirmware, StaysWhereItIsWhenVelocityZeroComesFirstAfterAGap) {
  OnBlocks robot;
  robot.open();
  (void)robot.send(command(Command::Enable, 1));
  (void)robot.send(command(Command::Velocity, 300));
  robot.run(1.5, true);
  robot.run(2.0, false);
  const double before = robot.firmware.odom_from_base().x;
  (void)robot.send(command(Command::Velocity, 0));
  robot.run(2.0, true);
  EXPECT_DOUBLE_EQ(robot.firmware.odom_from_base().x, before);
}

TEST(PioneerFirmware, StallsWhenBlockedThenPushesAgain) {
  OnBlocks robot;
  robot.open();
  (void)robot.send(command(Command::Enable, 1));
  (void)robot.send(command(Command::Velocity, 300));
  robot.run(1.0, true);
  const double before = robot.firmware.odom_from_base().x;
  robot.run(0.025, true, {.contact = {.front = true}, .blocked = true});
  const auto sip = robot.sip();
  EXPECT_TRUE(sip.left_stalled);
  EXPECT_TRUE(sip.right_stalled);
  EXPECT_NE(sip.front_bumpers, 0);
  EXPECT_EQ(sip.rear_bumpers, 0);
  EXPECT_DOUBLE_EQ(robot.firmware.odom_from_base().x, before);
  robot.run(0.4, true);
  EXPECT_EQ(robot.firmware.speed(), BodySpeed{});
  robot.run(1.2, true);  // the motors are back, and so is the speed
  EXPECT_DOUBLE_EQ(robot.firmware.speed().forward_mps, 0.3);
}

TEST(PioneerFirmware, TheStopButtonDropsTheMotorsAndItsReleaseDoesNotRaiseThem) {
  OnBlocks robot;
  robot.open();
  (void)robot.send(command(Command::Enable, 1));
  (void)robot.send(command(Command::Velocity, 300));
  robot.run(1.5, true);
  robot.firmware.press_stop(true);
  (void)robot.send(command(Command::Enable, 1));
  robot.run(0.1, true);
  EXPECT_EQ(robot.firmware.speed(), BodySpeed{});
  EXPECT_TRUE(robot.sip().stop_pressed());
  EXPECT_FALSE(robot.sip().motors_enabled());
  robot.firmware.press_stop(false);
  robot.run(1.0, true);
  EXPECT_EQ(robot.firmware.speed(), BodySpeed{});
}

TEST(PioneerFirmware, EmergencyStopIgnoresTheRamp) {
  OnBlocks robot;
  robot.open();
  (void)robot.send(command(Command::Enable, 1));
  (void)robot.send(command(Command::Velocity, 300));
  robot.run(1.5, true);
  (void)robot.send(command(Command::EmergencyStop));
  EXPECT_EQ(robot.firmware.speed(), BodySpeed{});
}

TEST(PioneerFirmware, WheelVelocitiesTurnItOnTheSpot) {
  OnBlocks robot;
  robot.open();
  (void)robot.send(command(Command::Enable, 1));
  (void)robot.send({0xFA, 0xFB, 0x06, 0x20, 0x3B, 0x0A, 0xF6, 0x2B, 0x31});  // right +10, left -10 x 20 mm/s
  robot.run(2.0, true);
  EXPECT_NEAR(robot.firmware.speed().forward_mps, 0.0, 1e-12);
  EXPECT_NEAR(robot.firmware.speed().turn_rate_radps, 0.2 * 3.4, 1e-9);  // 0.2 m/s at a half track of 1 / 3.4 m
  const auto sip = robot.sip();
  EXPECT_EQ(sip.left_velocity, -200);
  EXPECT_EQ(sip.right_velocity, 200);
}

TEST(PioneerFirmware, CountsDistanceModuloFifteenBits) {
  OnBlocks robot;
  robot.open();
  robot.firmware.settle({0x8000 * 0.00132 + 1.32, 0.0, 0.0}, {}, robot.now);  // once round, and 1000 counts
  EXPECT_NEAR(robot.sip().x, 1000, 1);
  robot.firmware.settle({-0x8000 * 0.00132 - 2.64, 0.0, 0.0}, {}, robot.now);
  EXPECT_NEAR(robot.sip().x, 0x8000 - 1000, 1);
}

TEST(PioneerFirmware, TellsItsWatchdogInTheConfigPacket) {
  OnBlocks robot{std::chrono::milliseconds{700}};
  robot.open();
  for (const auto& request : {command(Command::Config), command(Command::Config, 1)}) {
    const auto config = pioneer::decode_config(only_packet(robot.send(request)));
    ASSERT_TRUE(config);
    EXPECT_EQ(config->watchdog_ms, 700);
    EXPECT_EQ(config->sip_cycle_ms, 100);
    EXPECT_EQ(config->subtype, "p2at");
  }
}

TEST(PioneerFirmware, IsQuietOnWhatItDoesNotKnow) {
  OnBlocks robot;
  robot.open();
  for (const int number : {26, 40, 62, 58, 110, 224, 253, 255}) {
    EXPECT_TRUE(robot.send(command(static_cast<Command>(number), 2)).empty()) << number;
  }
  EXPECT_TRUE(robot.firmware.is_open());
}

TEST(PioneerFirmware, ShowsTheSonarFlagAndTheTestedBattery) {
  OnBlocks robot;
  robot.open();
  (void)robot.send(command(Command::Sonar, 0));
  EXPECT_EQ(robot.sip().flags & pioneer::sip_flag::kSonarArray1, 0);
  (void)robot.send(command(Command::Sonar, 1));
  EXPECT_NE(robot.sip().flags & pioneer::sip_flag::kSonarArray1, 0);
  EXPECT_NEAR(robot.sip().battery_v(), 12.8, 1e-9);
  (void)robot.send(command(Command::BatteryTest, 111));
  EXPECT_NEAR(robot.sip().battery_v(), 11.1, 1e-9);
}

TEST(PioneerFirmware, ReportsEveryCycleWhileOpen) {
  OnBlocks robot;
  EXPECT_FALSE(robot.firmware.is_report_due(robot.now + std::chrono::seconds{1}));
  robot.open();
  EXPECT_FALSE(robot.firmware.is_report_due(robot.now));
  robot.now += std::chrono::milliseconds{100};
  EXPECT_TRUE(robot.firmware.is_report_due(robot.now));
  (void)robot.sip();
  EXPECT_FALSE(robot.firmware.is_report_due(robot.now));
}

}  // namespace
}  // namespace tandem::simulator
