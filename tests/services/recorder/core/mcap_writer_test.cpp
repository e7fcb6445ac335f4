#include "services/recorder/core/mcap_writer.hpp"

#include <gtest/gtest.h>

#include "tests/services/recorder/core/mcap_files.hpp"

namespace tandem::mcap {
namespace {

TEST(McapWriter, ALiveFileThatWasClosedIsComplete) {
  Reader reader = opened(live_file(3));
  expect_all(reader, 3);
  EXPECT_TRUE(reader.complete());
}

TEST(McapWriter, AnIndexedFileGivesTheSameMessagesHoweverItIsCompressed) {
  for (const Compression compression : {Compression::None, Compression::Zstd, Compression::Lz4}) {
    for (const ReadBy by : {ReadBy::Summary, ReadBy::Records}) {
      Reader reader = opened(indexed_file(20, 200, compression), by);
      expect_all(reader, 20);
      EXPECT_TRUE(reader.complete()) << name_of(compression);
    }
  }
}

TEST(McapWriter, AFullDiskEndsTheFileAtTheLastWholeRecord) {
  Bytes bytes;
  LiveWriter writer{[&bytes](ByteView record) {
                      if (bytes.size() + record.size() > 400) return false;
                      bytes.insert(bytes.end(), record.begin(), record.end());
                      return true;
                    },
                    {"", "test"}};
  fill(writer, 100);
  EXPECT_FALSE(writer.finish());
  Reader reader = opened(bytes);
  EXPECT_GT(reader.message_count(), 0U);
  EXPECT_FALSE(reader.complete());
  EXPECT_TRUE(reader.damages().empty());
}

}  // namespace
}  // namespace tandem::mcap
