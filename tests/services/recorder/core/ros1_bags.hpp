#pragma once

#include <bzlib.h>

#include <string>
#include <utility>
#include <vector>

#include "services/recorder/core/mcap_compression.hpp"

/// ROS 1 bags in memory, written independently of what reads them.
namespace tandem::ros {

struct BagLine {
  std::string topic;
  std::string type;
  std::uint32_t time_s = 0;
  mcap::Bytes data;
};

inline std::string little_endian(std::uint64_t value, std::size_t size) {
  std::string text;
  for (std::size_t i = 0; i < size; ++i) text += static_cast<char>(value >> (8 * i));
  return text;
}

inline std::string fields(const std::vector<std::pair<std::string, std::string>>& all) {
  std::string text;
  for (const auto& [name, value] : all) {
    text += little_endian(name.size() + 1 + value.size(), 4) + name + "=" + value;
  }
  return text;
}

inline std::string bag_record(const std::string& header, const std::string& data) {
  return little_endian(header.size(), 4) + header + little_endian(data.size(), 4) + data;
}

inline std::string bz2_packed(const std::string& text) {
  std::string out(text.size() + 1000, '\0');
  auto size = static_cast<unsigned int>(out.size());
  std::string in = text;
  BZ2_bzBuffToBuffCompress(out.data(), &size, in.data(), static_cast<unsigned int>(in.size()), 9, 0, 0);
  out.resize(size);
  return out;
}

/// A bag of one chunk, compressed as `compression` says ("none", "bz2", "lz4").
inline mcap::Bytes ros1_bag(const std::vector<BagLine>& lines, const std::string& compression) {
  std::string chunk;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const BagLine& line = lines[i];
    const std::string id = little_endian(i, 4);
    chunk += bag_record(fields({{"op", "\x07"}, {"conn", id}, {"topic", line.topic}}),
                        fields({{"topic", line.topic}, {"type", line.type}, {"message_definition", "float32 a=b\n"}}));
    chunk += bag_record(
        fields({{"op", "\x02"}, {"conn", id}, {"time", little_endian(line.time_s, 4) + little_endian(250'000'000, 4)}}),
        {line.data.begin(), line.data.end()});
  }
  std::string packed = chunk;
  if (compression == "bz2") packed = bz2_packed(chunk);
  if (compression == "lz4") {
    const mcap::Bytes bytes = mcap::compressed(
        mcap::ByteView{reinterpret_cast<const std::uint8_t*>(chunk.data()), chunk.size()}, mcap::Compression::Lz4);
    packed = {bytes.begin(), bytes.end()};
  }
  const std::string text =
      "#ROSBAG V2.0\n" +
      bag_record(fields({{"op", "\x03"}, {"chunk_count", little_endian(1, 4)}}), std::string(30, ' ')) +
      bag_record(fields({{"op", "\x05"}, {"compression", compression}, {"size", little_endian(chunk.size(), 4)}}),
                 packed) +
      bag_record(fields({{"op", "\x04"}, {"conn", little_endian(0, 4)}}), "an index");
  return {text.begin(), text.end()};
}

}  // namespace tandem::ros
