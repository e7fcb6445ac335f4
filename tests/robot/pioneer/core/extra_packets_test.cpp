#include "robot/pioneer/core/extra_packets.hpp"

#include <gtest/gtest.h>

namespace tandem::pioneer {
namespace {

TEST(ExtraPackets, ComeBackAsTheyWereSent) {
  const EncoderPacket encoders{-2, 0x7FFFFFFF};
  EXPECT_EQ(decode_encoders(encode_encoders(encoders)), encoders);
  const IoPacket io{{1, 2, 3, 4}, {5}, {0x0102, 1023}};
  EXPECT_EQ(decode_io(encode_io(io)), io);
  const std::vector<GyroReading> readings{{512, 30}, {1023, 31}};
  EXPECT_EQ(decode_gyro(encode_gyro(readings)), readings);
}

TEST(ExtraPackets, PutEachFieldWhereTheProtocolSays) {
  EXPECT_EQ(encode_encoders({1, -1}).body, (Bytes{1, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF}));
  EXPECT_EQ(encode_io({{7}, {8, 9}, {0x0102}}).body, (Bytes{1, 7, 2, 8, 9, 1, 0x02, 0x01}));
  EXPECT_EQ(encode_gyro({{0x0203, 25}}).body, (Bytes{1, 0x03, 0x02, 25}));
}

TEST(ExtraPackets, AreNoneWhereTheyEndEarlyOrAreOthers) {
  for (Packet packet : {encode_encoders({1, 2}), encode_io({{7}, {8}, {9}}), encode_gyro({{512, 1}, {512, 1}})}) {
    packet.body.pop_back();
    EXPECT_FALSE(decode_encoders(packet));
    EXPECT_FALSE(decode_io(packet));
    EXPECT_FALSE(decode_gyro(packet));
  }
}

}  // namespace
}  // namespace tandem::pioneer
