#include "robot/pioneer/core/sip.hpp"

#include <gtest/gtest.h>

namespace tandem::pioneer {
namespace {

Sip old_robot() {
  Sip sip;
  sip.moving = true;
  sip.x = 0x7FFF;
  sip.y = 0x0102;
  sip.heading = -1024;
  sip.left_velocity = -10;
  sip.right_velocity = 300;
  sip.battery = 124;
  sip.right_stalled = true;
  sip.rear_bumpers = 0x03;
  sip.front_bumpers = 0x10;
  sip.flags = sip_flag::kMotorsEnabled | sip_flag::kSonarArray1;
  sip.sonar = {{0, 5000}, {7, 1234}};
  return sip;
}

Sip newest_robot() {
  Sip sip = old_robot();
  sip.gripper_state = 1;
  sip.analog_port = 2;
  sip.analog = 3;
  sip.digital_in = 4;
  sip.digital_out = 5;
  sip.battery_x10 = 258;
  sip.charge_state = 2;
  sip.turn_rate_x10 = -123;
  sip.fault_flags = 9;
  sip.lateral_velocity = -7;
  sip.temperature_c = -127;
  sip.state_of_charge = 88;
  sip.controller_time_us = 123456789;
  sip.flags3 = 0x80000001;
  return sip;
}

TEST(Sip, PutsEachFieldWhereTheProtocolSays) {
  const Packet packet = encode_sip(old_robot());

  EXPECT_EQ(packet.number, 0x33);
  EXPECT_EQ(packet.body, (Bytes{0xFF, 0x7F, 0x02, 0x01, 0x00, 0xFC, 0xF6, 0xFF, 0x2C, 0x01, 124,  0x06, 0x21,
                                0,    0,    0x03, 0x00, 0,    2,    0,    0x88, 0x13, 7,    0xD2, 0x04}));
}

TEST(Sip, ComesBackAsItWasSentWithAndWithoutOptionalFields) {
  EXPECT_EQ(decode_sip(encode_sip(old_robot())), old_robot());
  EXPECT_EQ(decode_sip(encode_sip(newest_robot())), newest_robot());
}

TEST(Sip, StopsReadingWhereThePacketEnds) {
  const Packet whole = encode_sip(newest_robot());
  for (std::size_t size = 0; size <= whole.body.size(); ++size) {
    SCOPED_TRACE(size);
    const Packet cut{whole.number, Bytes(whole.body.begin(), whole.body.begin() + static_cast<std::ptrdiff_t>(size))};
    const auto sip = decode_sip(cut);
    EXPECT_EQ(sip.has_value(), size >= 25);  // 19 bytes and two sonar readings of 3 each
    if (!sip) continue;
    EXPECT_EQ(sip->battery_x10.has_value(), size >= 25 + 5 + 2);
  }
}

TEST(Sip, PrefersTheBatteryFieldThatDoesNotSaturate) {
  EXPECT_DOUBLE_EQ(old_robot().battery_v(), 12.4);
  EXPECT_DOUBLE_EQ(newest_robot().battery_v(), 25.8);
}

TEST(Sip, SaysWhetherMotorsAreOnAndTheStopButtonIsIn) {
  Sip sip = old_robot();
  EXPECT_TRUE(sip.motors_enabled());
  EXPECT_FALSE(sip.stop_pressed());
  sip.flags = sip_flag::kStopPressed;
  EXPECT_FALSE(sip.motors_enabled());
  EXPECT_TRUE(sip.stop_pressed());
}

TEST(Sip, OfAnotherTypeIsNone) {
  EXPECT_FALSE(decode_sip({0x20, Bytes(30, 0)}));
}

}  // namespace
}  // namespace tandem::pioneer
