#pragma once

#include <gtest/gtest.h>

#include "services/recorder/core/mcap_reader.hpp"
#include "services/recorder/core/mcap_writer.hpp"

/// Small recordings in memory, and what must be in them.
namespace tandem::mcap {

inline Sink into(Bytes& bytes) {
  return [&bytes](ByteView record) {
    bytes.insert(bytes.end(), record.begin(), record.end());
    return true;
  };
}

inline ByteView bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

inline std::string text_of(ByteView bytes) {
  return {bytes.begin(), bytes.end()};
}

/// Two topics, `count` messages each, one log time apart; one metadata and one attachment record.
inline void fill(Writer& writer, int count) {
  ChannelTable channels{writer};
  writer.write(Metadata{"tandem", {{"seed", "7"}}});
  writer.write(Attachment{0, 0, "site.toml", "application/toml", "host = \"r\"\n"});
  for (int i = 0; i < count; ++i) {
    const auto time = static_cast<std::uint64_t>(1000 + 10 * i);
    const std::string number = std::to_string(i);
    channels.write(channels.channel_of("odometry", "tandem::msg::Odometry", "struct Odometry {};"), time, time - 1,
                   bytes_of("odometry " + number));
    channels.write(channels.channel_of("scan", "tandem::msg::LaserScan", "struct LaserScan {};"), time + 5, time,
                   bytes_of("scan " + number));
  }
}

inline Bytes live_file(int count, bool closed = true) {
  Bytes bytes;
  LiveWriter writer{into(bytes), {"", "test"}};
  fill(writer, count);
  if (closed) {
    EXPECT_TRUE(writer.finish());
  }
  return bytes;
}

inline Bytes indexed_file(int count, std::size_t chunk_size = 200, Compression compression = Compression::Zstd) {
  Bytes bytes;
  IndexedWriter writer{into(bytes), {"", "test"}, chunk_size, compression};
  fill(writer, count);
  EXPECT_TRUE(writer.finish());
  return bytes;
}

inline Reader opened(Bytes bytes, ReadBy by = ReadBy::Summary) {
  return Reader{memory_source(std::move(bytes)), "test.mcap", by};
}

inline void expect_all(Reader& reader, int count) {
  ASSERT_EQ(reader.message_count(), static_cast<std::size_t>(2 * count));
  for (int i = 0; i < 2 * count; ++i) {
    const auto message = reader.message_at(static_cast<std::size_t>(i));
    ASSERT_TRUE(message);
    EXPECT_EQ(message->log_time, static_cast<std::uint64_t>(1000 + 5 * i));
    EXPECT_EQ(message->sequence, static_cast<std::uint32_t>(i / 2));
    EXPECT_EQ(text_of(message->data), (i % 2 == 0 ? "odometry " : "scan ") + std::to_string(i / 2));
  }
}

}  // namespace tandem::mcap
