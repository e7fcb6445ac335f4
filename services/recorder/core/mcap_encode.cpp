#include <zlib.h>

#include <type_traits>

#include "services/recorder/core/mcap_records.hpp"

namespace tandem::mcap {
namespace {

template <typename Integer>
void put(Bytes& out, Integer value) {
  const auto bits = static_cast<std::make_unsigned_t<Integer>>(value);
  for (std::size_t i = 0; i < sizeof(Integer); ++i) out.push_back(static_cast<std::uint8_t>(bits >> (8 * i)));
}

void put(Bytes& out, const std::string& text) {
  put(out, static_cast<std::uint32_t>(text.size()));
  out.insert(out.end(), text.begin(), text.end());
}

void put(Bytes& out, const std::map<std::string, std::string>& entries) {
  Bytes content;
  for (const auto& [key, value] : entries) {
    put(content, key);
    put(content, value);
  }
  put(out, static_cast<std::uint32_t>(content.size()));
  out.insert(out.end(), content.begin(), content.end());
}

void put(Bytes& out, const std::map<std::uint16_t, std::uint64_t>& entries) {
  put(out, static_cast<std::uint32_t>(entries.size() * 10));
  for (const auto& [key, value] : entries) {
    put(out, key);
    put(out, value);
  }
}

/// Writes opcode and length, lets `content` append the rest, and fills in the length.
template <typename Content>
void put_record(Bytes& out, Opcode opcode, Content content) {
  out.push_back(static_cast<std::uint8_t>(opcode));
  const std::size_t length_at = out.size();
  put(out, std::uint64_t{0});
  content();
  const std::uint64_t length = out.size() - length_at - 8;
  for (std::size_t i = 0; i < 8; ++i) out[length_at + i] = static_cast<std::uint8_t>(length >> (8 * i));
}

}  // namespace

std::uint32_t crc32_of(ByteView bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(crc32_z(before, bytes.data(), bytes.size()));
}

void append(Bytes& out, const Header& header) {
  put_record(out, Opcode::Header, [&] {
    put(out, header.profile);
    put(out, header.library);
  });
}

void append(Bytes& out, const Schema& schema) {
  put_record(out, Opcode::Schema, [&] {
    put(out, schema.id);
    put(out, schema.name);
    put(out, schema.encoding);
    put(out, schema.text);
  });
}

void append(Bytes& out, const Channel& channel) {
  put_record(out, Opcode::Channel, [&] {
    put(out, channel.id);
    put(out, channel.schema_id);
    put(out, channel.topic);
    put(out, channel.message_encoding);
    put(out, channel.metadata);
  });
}

void append(Bytes& out, const Message& message) {
  put_record(out, Opcode::Message, [&] {
    put(out, message.channel_id);
    put(out, message.sequence);
    put(out, message.log_time);
    put(out, message.publish_time);
    out.insert(out.end(), message.data.begin(), message.data.end());
  });
}

void append(Bytes& out, const Chunk& chunk) {
  put_record(out, Opcode::Chunk, [&] {
    put(out, chunk.start_time);
    put(out, chunk.end_time);
    put(out, chunk.uncompressed_size);
    put(out, chunk.uncompressed_crc);
    put(out, chunk.compression);
    put(out, static_cast<std::uint64_t>(chunk.records.size()));
    out.insert(out.end(), chunk.records.begin(), chunk.records.end());
  });
}

void append(Bytes& out, const MessageIndex& index) {
  put_record(out, Opcode::MessageIndex, [&] {
    put(out, index.channel_id);
    put(out, static_cast<std::uint32_t>(index.entries.size() * 16));
    for (const auto& [time, offset] : index.entries) {
      put(out, time);
      put(out, offset);
    }
  });
}

void append(Bytes& out, const ChunkIndex& index) {
  put_record(out, Opcode::ChunkIndex, [&] {
    put(out, index.start_time);
    put(out, index.end_time);
    put(out, index.chunk_offset);
    put(out, index.chunk_length);
    put(out, index.message_index_offsets);
    put(out, index.message_index_length);
    put(out, index.compression);
    put(out, index.compressed_size);
    put(out, index.uncompressed_size);
  });
}

void append(Bytes& out, const Attachment& attachment) {
  put_record(out, Opcode::Attachment, [&] {
    const std::size_t start = out.size();
    put(out, attachment.log_time);
    put(out, attachment.create_time);
    put(out, attachment.name);
    put(out, attachment.media_type);
    put(out, static_cast<std::uint64_t>(attachment.data.size()));
    out.insert(out.end(), attachment.data.begin(), attachment.data.end());
    put(out, crc32_of(ByteView{out}.subspan(start)));
  });
}

void append(Bytes& out, const AttachmentIndex& index) {
  put_record(out, Opcode::AttachmentIndex, [&] {
    put(out, index.offset);
    put(out, index.length);
    put(out, index.log_time);
    put(out, index.create_time);
    put(out, index.data_size);
    put(out, index.name);
    put(out, index.media_type);
  });
}

void append(Bytes& out, const Statistics& statistics) {
  put_record(out, Opcode::Statistics, [&] {
    put(out, statistics.message_count);
    put(out, statistics.schema_count);
    put(out, statistics.channel_count);
    put(out, statistics.attachment_count);
    put(out, statistics.metadata_count);
    put(out, statistics.chunk_count);
    put(out, statistics.message_start_time);
    put(out, statistics.message_end_time);
    put(out, statistics.channel_message_counts);
  });
}

void append(Bytes& out, const Metadata& metadata) {
  put_record(out, Opcode::Metadata, [&] {
    put(out, metadata.name);
    put(out, metadata.entries);
  });
}

void append(Bytes& out, const MetadataIndex& index) {
  put_record(out, Opcode::MetadataIndex, [&] {
    put(out, index.offset);
    put(out, index.length);
    put(out, index.name);
  });
}

void append(Bytes& out, const SummaryOffset& offset) {
  put_record(out, Opcode::SummaryOffset, [&] {
    put(out, static_cast<std::uint8_t>(offset.group));
    put(out, offset.start);
    put(out, offset.length);
  });
}

void append(Bytes& out, const DataEnd& end) {
  put_record(out, Opcode::DataEnd, [&] { put(out, end.data_section_crc); });
}

void append(Bytes& out, const Footer& footer) {
  put_record(out, Opcode::Footer, [&] {
    put(out, footer.summary_start);
    put(out, footer.summary_offset_start);
    put(out, footer.summary_crc);
  });
}

}  // namespace tandem::mcap
