#include "services/recorder/core/recording_merge.hpp"

#include <gtest/gtest.h>

#include "tests/services/recorder/core/mcap_files.hpp"

namespace tandem::recorder {
namespace {

using mcap::Bytes;

/// A message of a small recording: topic, log time [s], payload.
struct Line {
  std::string topic;
  std::uint64_t time_s = 0;
  std::string payload;
};

constexpr std::uint64_t kSecond_ns = 1'000'000'000;

mcap::Reader recording(const std::vector<Line>& lines, const std::string& schema = "idl") {
  Bytes bytes;
  mcap::IndexedWriter writer{mcap::into(bytes), {"", "test"}};
  mcap::ChannelTable channels{writer};
  writer.write(mcap::Attachment{0, 0, "site.toml", "application/toml", "x = 1"});
  for (const Line& line : lines) {
    const std::uint16_t channel = channels.channel_of(line.topic, "a::" + line.topic, schema);
    channels.write(channel, line.time_s * kSecond_ns, line.time_s * kSecond_ns - 7, mcap::bytes_of(line.payload));
  }
  EXPECT_TRUE(writer.finish());
  return mcap::opened(bytes);
}

mcap::Reader merged(std::vector<MergedRecording> recordings, MergeCount* count = nullptr) {
  Bytes bytes;
  mcap::IndexedWriter writer{mcap::into(bytes), {"", "test"}};
  const MergeCount counted = merge(recordings, writer);
  if (count != nullptr) *count = counted;
  EXPECT_TRUE(writer.finish());
  return mcap::opened(bytes);
}

/// `scan@3:a odometry@4:b `, publish time 7 ns before each.
std::string text_of(mcap::Reader& reader) {
  std::string text;
  for (std::size_t i = 0; i < reader.message_count(); ++i) {
    const auto message = reader.message_at(i);
    EXPECT_EQ(message->log_time - message->publish_time, 7U);
    text += reader.channels().at(message->channel_id).topic + "@" + std::to_string(message->log_time / kSecond_ns) +
            ":" + mcap::text_of(message->data) + " ";
  }
  return text;
}

TEST(RecordingMerge, PutsTheSecondOnTheClockOfTheFirst) {
  mcap::Reader robot = recording({{"scan", 100, "a"}, {"scan", 104, "b"}});
  mcap::Reader laptop = recording({{"belief", 2, "x"}, {"belief", 3, "y"}});
  mcap::Reader both = merged({{&robot, "robot"}, {&laptop, "laptop", ClockLine{100.0}}});
  EXPECT_EQ(text_of(both), "scan@100:a belief@102:x belief@103:y scan@104:b ");
}

TEST(RecordingMerge, WritesWhatTheRelayCarriedOnceWhenItWasThereFirst) {
  mcap::Reader robot = recording({{"pose", 1, "p"}, {"pose", 2, "q"}, {"pose", 2, "q"}, {"scan", 4, "p"}});
  mcap::Reader laptop = recording({{"pose", 3, "q"}, {"pose", 2, "p"}});
  MergeCount count;
  mcap::Reader both = merged({{&robot, "robot"}, {&laptop, "laptop"}}, &count);
  // q came twice on the robot, and that is how often it is here; p on another topic is another message.
  EXPECT_EQ(text_of(both), "pose@1:p pose@2:q pose@2:q scan@4:p ");
  EXPECT_EQ(count.written, 4U);
  EXPECT_EQ(count.doubled, 2U);
}

TEST(RecordingMerge, KeepsTheAttachmentsOfBothUnderTheirHosts) {
  mcap::Reader robot = recording({{"scan", 1, "a"}});
  mcap::Reader laptop = recording({{"scan", 1, "b"}});
  mcap::Reader both = merged({{&robot, "robot"}, {&laptop, "laptop"}});
  const auto attachments = both.attachments();
  ASSERT_EQ(attachments.size(), 2U);
  EXPECT_EQ(attachments[0].name, "robot/site.toml");
  EXPECT_EQ(attachments[1].name, "laptop/site.toml");
}

TEST(RecordingMerge, RefusesATopicOfTwoSchemas) {
  mcap::Reader robot = recording({{"scan", 1, "a"}}, "old");
  mcap::Reader laptop = recording({{"scan", 1, "b"}}, "new");
  EXPECT_THROW((void)merged({{&robot, "robot"}, {&laptop, "laptop"}}), mcap::McapError);
}

}  // namespace
}  // namespace tandem::recorder
