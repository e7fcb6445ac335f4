#include "services/recorder/clock_offsets.hpp"

#include <gtest/gtest.h>

#include "idl/topics.hpp"
#include "services/bus/codec.hpp"
#include "tests/services/recorder/core/mcap_files.hpp"

namespace tandem::recorder {
namespace {

/// A recording of `host`, whose relay measured at `time_ns` that the clock of `peer` is `offset_s` ahead; none without
/// a peer.
mcap::Reader recording(const std::string& host, const std::string& peer = "", std::uint64_t time_ns = 0,
                       double offset_s = 0.0) {
  mcap::Bytes bytes;
  mcap::IndexedWriter writer{mcap::into(bytes), {"", "test"}};
  mcap::ChannelTable channels{writer};
  writer.write(mcap::Metadata{"tandem", {{"host", host}}});
  msg::LinkStatus status;
  status.host(host);
  status.peer(peer);
  status.up(!peer.empty());
  status.round_trip_s(0.01);
  status.clock_offset_s(offset_s);
  const auto payload = bus::encode<msg::LinkStatusPubSubType>(status);
  channels.write(channels.channel_of("link_status", "tandem::msg::LinkStatus", "idl"), time_ns, 0, payload);
  EXPECT_TRUE(writer.finish());
  return mcap::opened(bytes);
}

TEST(ClockOffsets, AreWhatTheOtherHostMeasured) {
  mcap::Reader robot = recording("robot");
  mcap::Reader laptop = recording("laptop", "robot", 50, 2.0);
  const auto clock = clock_ahead(robot, laptop);
  ASSERT_TRUE(clock);
  EXPECT_DOUBLE_EQ(clock->offset_s_at(50), 2.0);
}

TEST(ClockOffsets, AreElseWhatTheFirstMeasuredTurnedRound) {
  mcap::Reader robot = recording("robot", "laptop", 5'000'000'000, -2.0);  // the laptop is 2 s behind
  mcap::Reader laptop = recording("laptop");
  const auto clock = clock_ahead(robot, laptop);
  ASSERT_TRUE(clock);
  EXPECT_DOUBLE_EQ(clock->offset_s_at(3'000'000'000), 2.0);
}

TEST(ClockOffsets, OfPartsOfOneRecordingAreZero) {
  mcap::Reader first = recording("robot");
  mcap::Reader second = recording("robot");
  EXPECT_DOUBLE_EQ(clock_ahead(first, second)->offset_s_at(7), 0.0);
}

TEST(ClockOffsets, AreUnknownWithoutALink) {
  mcap::Reader robot = recording("robot", "another laptop", 1, 1.0);
  mcap::Reader laptop = recording("laptop");
  EXPECT_FALSE(clock_ahead(robot, laptop));
}

}  // namespace
}  // namespace tandem::recorder
