// What a host may ask of the simulated controller besides driving: packets, goals, switches.
#include <gtest/gtest.h>

#include "robot/pioneer/core/config_packet.hpp"
#include "robot/pioneer/core/extra_packets.hpp"
#include "robot/pioneer/core/gyro.hpp"
#include "tests/services/simulator/core/controller_on_blocks.hpp"

namespace tandem::simulator {
namespace {

using pioneer::Bytes;
using pioneer::Command;
using pioneer::command;

OnBlocks driving(const FirmwareOptions& options = OnBlocks::options()) {
  OnBlocks robot{options};
  robot.open();
  (void)robot.send(command(Command::Enable, 1));
  return robot;
}

TEST(PioneerReports, EncodersAreSentOnceOrAsAStreamAndCountTheWheelsWay) {
  OnBlocks robot = driving();
  EXPECT_TRUE(robot.send(command(Command::Encoder, 2)).empty());
  (void)robot.send(command(Command::Velocity, 300));
  robot.run(3.0, true);
  const auto packets = robot.report();
  ASSERT_EQ(packets.size(), 2u);
  const auto encoders = pioneer::decode_encoders(packets[1]);
  ASSERT_TRUE(encoders);
  EXPECT_EQ(encoders->left_ticks, encoders->right_ticks);
  EXPECT_NEAR(encoders->left_ticks, 128'000.0 * robot.firmware.odom_from_base().x, 2.0);

  (void)robot.send(command(Command::Encoder, 0));
  EXPECT_EQ(robot.report().size(), 1u);
  EXPECT_FALSE(robot.send(command(Command::Encoder, 1)).empty());
  EXPECT_EQ(robot.report().size(), 1u);
}

TEST(PioneerReports, EncodersOfATurnInPlaceCountAgainstEachOther) {
  OnBlocks robot = driving();
  (void)robot.send(command(Command::Encoder, 2));
  (void)robot.send(command(Command::TurnRate, 30));
  robot.run(2.0, true);
  const auto encoders = *pioneer::decode_encoders(robot.report().at(1));
  EXPECT_GT(encoders.right_ticks, 10'000);
  EXPECT_NEAR(encoders.right_ticks, -encoders.left_ticks, 2);
}

TEST(PioneerReports, InputsAndOutputsAreSentWhenAskedForAndOutputsAreSwitchedByTheirMask) {
  OnBlocks robot = driving();
  (void)robot.send(pioneer::packed_command(Command::DigitalOut, 0x0F, 0xFF));
  (void)robot.send(pioneer::packed_command(Command::DigitalOut, 0x01, 0x00));
  (void)robot.send(command(Command::AnalogSelect, 3));
  robot.firmware.faults().digital_in = 0x40;
  (void)robot.send(command(Command::IoRequest, 2));
  const auto packets = robot.report();
  ASSERT_EQ(packets.size(), 2u);
  const auto sip = pioneer::decode_sip(packets[0]);
  EXPECT_EQ(sip->digital_out, 0x0E);
  EXPECT_EQ(sip->digital_in, 0x40);
  EXPECT_EQ(sip->analog_port, 3);
  const auto io = pioneer::decode_io(packets[1]);
  ASSERT_TRUE(io);
  EXPECT_EQ(io->digital_in.at(0), 0x40);
  EXPECT_EQ(io->digital_out.at(0), 0x0E);
}

TEST(PioneerReports, AGyroTurnsWithTheRobotWhereOneIsFitted) {
  FirmwareOptions options = OnBlocks::options();
  options.has_gyro = true;
  OnBlocks robot = driving(options);
  (void)robot.send(command(Command::Gyro, 1));
  pioneer::Gyro gyro;
  double turned = 0.0;
  for (int i = 0; i < 60; ++i) {
    if (i == 20) (void)robot.send(command(Command::TurnRate, 30));
    robot.run(0.1, true);
    const auto readings = pioneer::decode_gyro(robot.report().at(1));
    ASSERT_TRUE(readings);
    ASSERT_EQ(readings->size(), 4u);
    gyro.take(*readings, i < 20);
    turned += gyro.take_turn().value_or(0.0);
  }
  EXPECT_NEAR(turned, robot.firmware.odom_from_base().heading, 0.06);
  EXPECT_GT(turned, 1.8);

  OnBlocks without = driving();
  (void)without.send(command(Command::Gyro, 1));
  EXPECT_EQ(without.report().size(), 1u);
}

TEST(PioneerReports, NewerRobotsAppendToTheStandardPacket) {
  FirmwareOptions options = OnBlocks::options();
  options.extended_sips = true;
  options.battery_v = 26.2;
  OnBlocks robot = driving(options);
  (void)robot.send(command(Command::TurnRate, -30));
  robot.run(2.0, true);
  const auto sip = robot.sip();
  EXPECT_EQ(sip.battery, 255);
  EXPECT_NEAR(sip.battery_v(), 26.2, 1e-9);
  EXPECT_EQ(sip.turn_rate_x10, -300);
  EXPECT_EQ(OnBlocks{}.sip().battery_x10, std::nullopt);
}

TEST(PioneerReports, GoesToAHeadingAndMovesByADistance) {
  OnBlocks robot = driving();
  (void)robot.send(command(Command::Heading, 90));
  robot.run(6.0, true);
  EXPECT_NEAR(robot.firmware.odom_from_base().heading, from_degrees(90), 0.02);
  (void)robot.send(command(Command::DeltaHeading, -30));
  robot.run(6.0, true);
  EXPECT_NEAR(robot.firmware.odom_from_base().heading, from_degrees(60), 0.02);
  (void)robot.send(command(Command::DeltaHeadingFromSetpoint, -60));
  robot.run(6.0, true);
  EXPECT_NEAR(robot.firmware.odom_from_base().heading, 0.0, 0.02);
  const double x = robot.firmware.odom_from_base().x;
  (void)robot.send(command(Command::Move, 1000));
  robot.run(12.0, true);
  EXPECT_NEAR(robot.firmware.odom_from_base().x - x, 1.0, 0.03);
  (void)robot.send(command(Command::Move, 3000));
  robot.run(1.0, true);
  (void)robot.send(command(Command::Velocity, 0));
  robot.run(4.0, true);
  EXPECT_EQ(robot.firmware.speed().forward_mps, 0.0) << "a velocity ends a move";
}

}  // namespace
}  // namespace tandem::simulator
