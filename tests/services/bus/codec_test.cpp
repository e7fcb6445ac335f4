#include "services/bus/codec.hpp"

#include <gtest/gtest.h>

#include "idl/topics.hpp"

namespace tandem::bus {
namespace {

std::vector<std::uint8_t> some_odometry() {
  msg::Odometry odometry;
  odometry.robot("robot1");
  odometry.stamp_ns(42);
  return encode<msg::OdometryPubSubType>(odometry);
}

TEST(Codec, GivesBackWhatWasEncoded) {
  const auto decoded = decode<msg::OdometryPubSubType>(some_odometry());

  ASSERT_TRUE(decoded);
  EXPECT_EQ(decoded->robot(), "robot1");
  EXPECT_EQ(decoded->stamp_ns(), 42);
}

TEST(Codec, RefusesEveryTruncation) {
  const auto whole = some_odometry();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_FALSE(decode<msg::OdometryPubSubType>({whole.begin(), whole.begin() + static_cast<long>(size)})) << size;
  }
}

TEST(Codec, RefusesAnUnknownEncapsulationWithoutThrowing) {
  auto bytes = some_odometry();
  bytes[0] = 0x12;
  bytes[1] = 0x34;
  EXPECT_NO_THROW(EXPECT_FALSE(decode<msg::OdometryPubSubType>(bytes)));
}

TEST(Codec, KeyHashTellsRobotsApart) {
  msg::Odometry one;
  one.robot("robot1");
  msg::Odometry two;
  two.robot("robot2");
  EXPECT_NE(key_of<msg::OdometryPubSubType>(one), key_of<msg::OdometryPubSubType>(two));
}

}  // namespace
}  // namespace tandem::bus
