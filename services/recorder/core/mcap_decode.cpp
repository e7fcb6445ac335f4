#include "services/recorder/core/mcap_records.hpp"

namespace tandem::mcap {
namespace {

/// Takes values off the front of a content; after one that is not there, everything is "not there".
class Reader {
 public:
  explicit Reader(ByteView bytes) : rest_(bytes) {}
  [[nodiscard]] bool good() const { return good_; }
  [[nodiscard]] ByteView rest() const { return rest_; }

  ByteView take(std::uint64_t length) {
    if (!good_ || length > rest_.size()) {
      good_ = false;
      return {};
    }
    const ByteView taken = rest_.first(static_cast<std::size_t>(length));
    rest_ = rest_.subspan(static_cast<std::size_t>(length));
    return taken;
  }
  template <typename Integer>
  void get(Integer& value) {
    const ByteView bytes = take(sizeof(Integer));
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) bits |= static_cast<std::uint64_t>(bytes[i]) << (8 * i);
    value = static_cast<Integer>(bits);
  }
  void get(std::string& text) {
    std::uint32_t length = 0;
    get(length);
    const ByteView bytes = take(length);
    text.assign(bytes.begin(), bytes.end());
  }
  void get(std::map<std::string, std::string>& entries) {
    std::uint32_t length = 0;
    get(length);
    Reader inside{take(length)};
    while (good_ && inside.good() && !inside.rest().empty()) {
      std::string key;
      std::string value;
      inside.get(key);
      inside.get(value);
      entries.emplace(std::move(key), std::move(value));
    }
    good_ = good_ && inside.good();
  }
  void get(std::map<std::uint16_t, std::uint64_t>& entries) {
    std::uint32_t length = 0;
    get(length);
    Reader inside{take(length)};
    while (good_ && inside.good() && !inside.rest().empty()) {
      std::uint16_t key = 0;
      std::uint64_t value = 0;
      inside.get(key);
      inside.get(value);
      entries.emplace(key, value);
    }
    good_ = good_ && inside.good();
  }

 private:
  ByteView rest_;
  bool good_ = true;
};

template <typename Record>
std::optional<Record> checked(const Reader& reader, Record record) {
  if (!reader.good()) return std::nullopt;
  return record;
}

}  // namespace

template <>
std::optional<Header> parse(ByteView content) {
  Reader reader{content};
  Header header;
  reader.get(header.profile);
  reader.get(header.library);
  return checked(reader, header);
}

template <>
std::optional<Schema> parse(ByteView content) {
  Reader reader{content};
  Schema schema;
  reader.get(schema.id);
  reader.get(schema.name);
  reader.get(schema.encoding);
  reader.get(schema.text);
  return checked(reader, std::move(schema));
}

template <>
std::optional<Channel> parse(ByteView content) {
  Reader reader{content};
  Channel channel;
  reader.get(channel.id);
  reader.get(channel.schema_id);
  reader.get(channel.topic);
  reader.get(channel.message_encoding);
  reader.get(channel.metadata);
  return checked(reader, std::move(channel));
}

template <>
std::optional<Message> parse(ByteView content) {
  Reader reader{content};
  Message message;
  reader.get(message.channel_id);
  reader.get(message.sequence);
  reader.get(message.log_time);
  reader.get(message.publish_time);
  message.data = reader.rest();
  return checked(reader, message);
}

template <>
std::optional<Chunk> parse(ByteView content) {
  Reader reader{content};
  Chunk chunk;
  reader.get(chunk.start_time);
  reader.get(chunk.end_time);
  reader.get(chunk.uncompressed_size);
  reader.get(chunk.uncompressed_crc);
  reader.get(chunk.compression);
  std::uint64_t length = 0;
  reader.get(length);
  chunk.records = reader.take(length);
  return checked(reader, std::move(chunk));
}

template <>
std::optional<MessageIndex> parse(ByteView content) {
  Reader reader{content};
  MessageIndex index;
  std::uint32_t length = 0;
  reader.get(index.channel_id);
  reader.get(length);
  Reader inside{reader.take(length)};
  while (reader.good() && inside.good() && !inside.rest().empty()) {
    std::uint64_t time = 0;
    std::uint64_t offset = 0;
    inside.get(time);
    inside.get(offset);
    index.entries.emplace_back(time, offset);
  }
  if (!inside.good()) return std::nullopt;
  return checked(reader, std::move(index));
}

template <>
std::optional<ChunkIndex> parse(ByteView content) {
  Reader reader{content};
  ChunkIndex index;
  reader.get(index.start_time);
  reader.get(index.end_time);
  reader.get(index.chunk_offset);
  reader.get(index.chunk_length);
  reader.get(index.message_index_offsets);
  reader.get(index.message_index_length);
  reader.get(index.compression);
  reader.get(index.compressed_size);
  reader.get(index.uncompressed_size);
  return checked(reader, std::move(index));
}

template <>
std::optional<Attachment> parse(ByteView content) {
  Reader reader{content};
  Attachment attachment;
  reader.get(attachment.log_time);
  reader.get(attachment.create_time);
  reader.get(attachment.name);
  reader.get(attachment.media_type);
  std::uint64_t length = 0;
  reader.get(length);
  const ByteView data = reader.take(length);
  attachment.data.assign(data.begin(), data.end());
  const std::size_t covered = content.size() - reader.rest().size();
  std::uint32_t crc = 0;
  reader.get(crc);
  if (reader.good() && crc != 0 && crc != crc32_of(content.first(covered))) return std::nullopt;
  return checked(reader, std::move(attachment));
}

template <>
std::optional<AttachmentIndex> parse(ByteView content) {
  Reader reader{content};
  AttachmentIndex index;
  reader.get(index.offset);
  reader.get(index.length);
  reader.get(index.log_time);
  reader.get(index.create_time);
  reader.get(index.data_size);
  reader.get(index.name);
  reader.get(index.media_type);
  return checked(reader, std::move(index));
}

template <>
std::optional<Metadata> parse(ByteView content) {
  Reader reader{content};
  Metadata metadata;
  reader.get(metadata.name);
  reader.get(metadata.entries);
  return checked(reader, std::move(metadata));
}

template <>
std::optional<MetadataIndex> parse(ByteView content) {
  Reader reader{content};
  MetadataIndex index;
  reader.get(index.offset);
  reader.get(index.length);
  reader.get(index.name);
  return checked(reader, std::move(index));
}

template <>
std::optional<Statistics> parse(ByteView content) {
  Reader reader{content};
  Statistics statistics;
  reader.get(statistics.message_count);
  reader.get(statistics.schema_count);
  reader.get(statistics.channel_count);
  reader.get(statistics.attachment_count);
  reader.get(statistics.metadata_count);
  reader.get(statistics.chunk_count);
  reader.get(statistics.message_start_time);
  reader.get(statistics.message_end_time);
  reader.get(statistics.channel_message_counts);
  return checked(reader, std::move(statistics));
}

template <>
std::optional<DataEnd> parse(ByteView content) {
  Reader reader{content};
  DataEnd end;
  reader.get(end.data_section_crc);
  return checked(reader, end);
}

template <>
std::optional<Footer> parse(ByteView content) {
  Reader reader{content};
  Footer footer;
  reader.get(footer.summary_start);
  reader.get(footer.summary_offset_start);
  reader.get(footer.summary_crc);
  return checked(reader, footer);
}

}  // namespace tandem::mcap
