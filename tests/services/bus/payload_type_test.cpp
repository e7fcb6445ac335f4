#include "services/bus/payload_type.hpp"

#include <gtest/gtest.h>

#include "services/bus/codec.hpp"

namespace tandem::bus {
namespace {

const TopicInfo& odometry_topic() {
  static const TopicInfo info = info_of(topic::kOdometry);
  return info;
}

msg::Odometry odometry_of(const std::string& robot) {
  msg::Odometry odometry;
  odometry.robot(robot);
  return odometry;
}

TEST(PayloadType, FindsTheKeyThatTheTypedCodecFinds) {
  const auto odometry = odometry_of("robot1");

  EXPECT_EQ(PayloadType{odometry_topic()}.key_of(encode<msg::OdometryPubSubType>(odometry)),
            key_of<msg::OdometryPubSubType>(odometry));
}

msg::ServiceHealth health_of(const std::string& host, const std::string& service) {
  msg::ServiceHealth health;
  health.host(host);
  health.service(service);
  return health;
}

// Between two strings of a key lie up to three bytes that generated code does not write.
TEST(PayloadType, AKeyDoesNotDependOnWhatWasAskedBefore) {
  const PayloadType type{info_of(topic::kServiceHealth)};
  const auto wanted = encode<msg::ServiceHealthPubSubType>(health_of("laptop-of-robot1", "gateway"));
  const auto key = type.key_of(wanted);
  EXPECT_EQ(key, key_of<msg::ServiceHealthPubSubType>(health_of("laptop-of-robot1", "gateway")));
  (void)type.key_of(encode<msg::ServiceHealthPubSubType>(health_of("a-host-of-a-long-name-indeed", "localization")));
  EXPECT_EQ(type.key_of(wanted), key);
}

TEST(PayloadType, ATopicWithoutKeyHasTheKeyOfZeros) {
  EXPECT_EQ(PayloadType{info_of(topic::kClock)}.key_of(encode<msg::ClockPubSubType>({})), KeyHash{});
}

TEST(PayloadType, AMessageCutShortAnywhereIsNotWellFormedAndHasNoKey) {
  const auto whole = encode<msg::OdometryPubSubType>(odometry_of("robot1"));
  const PayloadType type{odometry_topic()};

  EXPECT_TRUE(type.is_well_formed(whole));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_FALSE(type.is_well_formed(std::span{whole}.first(size))) << size;
    EXPECT_FALSE(type.key_of(std::span{whole}.first(size))) << size;
  }
}

TEST(PayloadType, UnknownCdrEncapsulationIsNotWellFormed) {
  auto payload = encode<msg::OdometryPubSubType>(odometry_of("robot1"));
  payload[1] = 0x34;

  EXPECT_FALSE(PayloadType{odometry_topic()}.is_well_formed(payload));
}

}  // namespace
}  // namespace tandem::bus
