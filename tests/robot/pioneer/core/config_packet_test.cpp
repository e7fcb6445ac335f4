#include "robot/pioneer/core/config_packet.hpp"

#include <gtest/gtest.h>

namespace tandem::pioneer {
namespace {

TEST(ConfigPacket, ComesBackAsItWasSent) {
  ConfigPacket config;
  config.type = "Pioneer";
  config.subtype = "p2at";
  config.serial_number = "0042";
  config.top_speed = 1500;
  config.name = "Tibi";
  config.sip_cycle_ms = 100;
  config.watchdog_ms = 2000;
  config.acceleration = 300;
  config.deceleration = 600;
  config.drift_factor = -12;
  config.firmware_version = "1.M";
  config.kinematics_delay_ms = 15;

  EXPECT_EQ(decode_config(encode_config(config)), config);
}

TEST(ConfigPacket, LeavesFieldsBehindItsEndUnknown) {
  ConfigPacket config;
  config.type = "Pioneer";
  config.top_turn_rate = 0x0102;
  config.deceleration = 600;
  Packet packet = encode_config(config);
  packet.body.resize(7 + 1 + 1 + 1 + 1 + 2);  // three texts, one byte, the top turn rate

  const auto cut = decode_config(packet);
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->top_turn_rate, 0x0102);
  EXPECT_EQ(cut->deceleration, 0);
}

TEST(ConfigPacket, FitsIntoOnePacket) {
  ConfigPacket config;
  config.type = config.subtype = config.serial_number = config.name = config.firmware_version = "sixteen letters!";

  EXPECT_LE(encode_config(config).body.size(), kMaxBody);
}

}  // namespace
}  // namespace tandem::pioneer
