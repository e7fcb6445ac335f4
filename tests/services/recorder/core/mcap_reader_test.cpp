#include "services/recorder/core/mcap_reader.hpp"

#include <gtest/gtest.h>

#include "tests/services/recorder/core/mcap_files.hpp"

namespace tandem::mcap {
namespace {

TEST(McapReader, SchemasMetadataAndAttachmentsComeBack) {
  for (const Bytes& bytes : {live_file(1), indexed_file(1)}) {
    Reader reader = opened(bytes);
    const Channel* scan = reader.channel_of("scan");
    ASSERT_NE(scan, nullptr);
    EXPECT_EQ(scan->message_encoding, "cdr");
    EXPECT_EQ(reader.schemas().at(scan->schema_id).name, "tandem::msg::LaserScan");
    EXPECT_EQ(reader.schemas().at(scan->schema_id).encoding, "omgidl");
    ASSERT_EQ(reader.metadata().size(), 1U);
    EXPECT_EQ(reader.metadata()[0].entries.at("seed"), "7");
    ASSERT_EQ(reader.attachments().size(), 1U);
    EXPECT_EQ(reader.attachments()[0].data, "host = \"r\"\n");
  }
}

TEST(McapReader, MessagesComeInOrderOfLogTimeAndOfWritingWhereThatIsEqual) {
  Bytes bytes;
  IndexedWriter writer{into(bytes), {"", "test"}, 100};
  ChannelTable channels{writer};
  const std::uint16_t channel = channels.channel_of("odometry", "tandem::msg::Odometry", "");
  for (const auto& [time, text] : {std::pair{30, "d"}, {10, "a"}, {20, "b"}, {20, "c"}}) {
    channels.write(channel, static_cast<std::uint64_t>(time), 0, bytes_of(text));
  }
  ASSERT_TRUE(writer.finish());
  Reader reader = opened(bytes);
  std::string order;
  for (std::size_t i = 0; i < reader.message_count(); ++i) order += text_of(reader.message_at(i)->data);
  EXPECT_EQ(order, "abcd");
}

TEST(McapReader, ARecordingCutShortOpensUpToTheLastWholeRecord) {
  const Bytes whole = live_file(3, false);
  std::vector<std::size_t> message_ends;  // where each message's record ends
  {
    Bytes bytes;
    LiveWriter writer{[&](ByteView record) {
                        bytes.insert(bytes.end(), record.begin(), record.end());
                        if (record[0] == static_cast<std::uint8_t>(Opcode::Message))
                          message_ends.push_back(bytes.size());
                        return true;
                      },
                      {"", "test"}};
    fill(writer, 3);
  }
  for (std::size_t length = 0; length <= whole.size(); ++length) {
    Reader reader = opened({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)});
    const auto expected = static_cast<std::size_t>(
        std::count_if(message_ends.begin(), message_ends.end(), [length](std::size_t end) { return end <= length; }));
    EXPECT_EQ(reader.message_count(), expected) << "cut at byte " << length;
    EXPECT_FALSE(reader.complete()) << "cut at byte " << length;
    EXPECT_TRUE(reader.damages().empty()) << "cut at byte " << length;
    for (std::size_t i = 0; i < expected; ++i) EXPECT_TRUE(reader.message_at(i));
  }
}

TEST(McapReader, AnIndexedFileCutShortOpensUpToTheLastWholeChunk) {
  const Bytes whole = indexed_file(10);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    Reader reader = opened({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)});
    EXPECT_FALSE(reader.complete()) << "cut at byte " << length;
    EXPECT_LE(reader.message_count(), 20U);
    for (std::size_t i = 0; i < reader.message_count(); ++i) EXPECT_TRUE(reader.message_at(i));
  }
}

TEST(McapReader, AFlippedBitIsReportedWithItsPlaceAndTheRestIsRead) {
  for (const Bytes& whole : {indexed_file(10), live_file(10)}) {
    std::size_t unnoticed = 0;
    for (std::size_t at = sizeof(kMagic); at < whole.size(); ++at) {
      Bytes bytes = whole;
      bytes[at] ^= 0x10;
      Reader reader = opened(bytes);
      std::size_t readable = 0;
      for (std::size_t i = 0; i < reader.message_count(); ++i) readable += reader.message_at(i).has_value();
      if (readable < 20 && reader.complete()) ++unnoticed;
      for (const std::string& damage : reader.damages()) EXPECT_EQ(damage.find("test.mcap: byte "), 0U);
    }
    EXPECT_EQ(unnoticed, 0U);
  }
}

TEST(McapReader, ADamagedChunkCostsItsOwnMessagesOnly) {
  Bytes bytes = indexed_file(10);
  bytes[bytes.size() / 3] ^= 0x01;
  Reader reader = opened(bytes);
  std::size_t readable = 0;
  for (std::size_t i = 0; i < reader.message_count(); ++i) readable += reader.message_at(i).has_value();
  EXPECT_GE(readable, 10U);
  EXPECT_LT(readable, 20U);
  EXPECT_EQ(reader.damages().size(), 1U);
}

TEST(McapReader, WhatIsNoMcapFileIsRefusedByName) {
  const std::string text = "ODOM 0 0 0 is a text";
  EXPECT_THROW(
      {
        try {
          (void)opened({text.begin(), text.end()});
        } catch (const McapError& error) {
          EXPECT_STREQ(error.what(), "test.mcap: is not a recording (no MCAP file)");
          throw;
        }
      },
      McapError);
}

}  // namespace
}  // namespace tandem::mcap
