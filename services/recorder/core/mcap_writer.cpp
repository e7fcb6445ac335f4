#include "services/recorder/core/mcap_writer.hpp"

#include <algorithm>

namespace tandem::mcap {
namespace {

Bytes opening(const Header& header) {
  Bytes bytes{std::begin(kMagic), std::end(kMagic)};
  append(bytes, header);
  return bytes;
}

template <typename Record>
void append_group(Bytes& out, std::vector<SummaryOffset>& offsets, std::uint64_t origin, Opcode group,
                  const std::vector<Record>& records) {
  if (records.empty()) return;
  const std::size_t start = out.size();
  for (const Record& record : records) append(out, record);
  offsets.push_back({group, origin + start, out.size() - start});
}

}  // namespace

bool CheckedSink::put(ByteView bytes) {
  if (!good_) return false;
  good_ = sink_(bytes);
  if (!good_) return false;
  crc_ = crc32_of(bytes, crc_);
  position_ += bytes.size();
  return true;
}

LiveWriter::LiveWriter(Sink sink, const Header& header) : sink_(std::move(sink)) {
  sink_.put(opening(header));
}

template <typename Record>
bool LiveWriter::put(const Record& record) {
  buffer_.clear();
  append(buffer_, record);
  return sink_.put(buffer_);
}

bool LiveWriter::write(const Schema& schema) {
  return put(schema);
}
bool LiveWriter::write(const Channel& channel) {
  return put(channel);
}
bool LiveWriter::write(const Message& message) {
  return put(message);
}
bool LiveWriter::write(const Attachment& attachment) {
  return put(attachment);
}
bool LiveWriter::write(const Metadata& metadata) {
  return put(metadata);
}

bool LiveWriter::finish() {
  Bytes end;
  append(end, DataEnd{sink_.crc()});
  append(end, Footer{});
  end.insert(end.end(), std::begin(kMagic), std::end(kMagic));
  return sink_.put(end);
}

IndexedWriter::IndexedWriter(Sink sink, const Header& header, std::size_t chunk_size, Compression compression)
    : sink_(std::move(sink)), chunk_size_(chunk_size), compression_(compression) {
  sink_.put(opening(header));
}

bool IndexedWriter::write(const Schema& schema) {
  append(chunk_, schema);
  schemas_.push_back(schema);
  return sink_.good();
}

bool IndexedWriter::write(const Channel& channel) {
  append(chunk_, channel);
  channels_.push_back(channel);
  return sink_.good();
}

bool IndexedWriter::write(const Message& message) {
  if (chunk_messages_.empty()) chunk_start_time_ = chunk_end_time_ = message.log_time;
  chunk_start_time_ = std::min(chunk_start_time_, message.log_time);
  chunk_end_time_ = std::max(chunk_end_time_, message.log_time);
  MessageIndex& index = chunk_messages_[message.channel_id];
  index.channel_id = message.channel_id;
  index.entries.emplace_back(message.log_time, chunk_.size());
  append(chunk_, message);

  const bool first = statistics_.message_count == 0;
  statistics_.message_start_time =
      first ? message.log_time : std::min(statistics_.message_start_time, message.log_time);
  statistics_.message_end_time = std::max(statistics_.message_end_time, message.log_time);
  ++statistics_.message_count;
  ++statistics_.channel_message_counts[message.channel_id];
  return chunk_.size() < chunk_size_ ? sink_.good() : flush_chunk();
}

bool IndexedWriter::write(const Attachment& attachment) {
  Bytes record;
  append(record, attachment);
  attachment_indexes_.push_back({sink_.position(), record.size(), attachment.log_time, attachment.create_time,
                                 attachment.data.size(), attachment.name, attachment.media_type});
  return sink_.put(record);
}

bool IndexedWriter::write(const Metadata& metadata) {
  Bytes record;
  append(record, metadata);
  metadata_indexes_.push_back({sink_.position(), record.size(), metadata.name});
  return sink_.put(record);
}

bool IndexedWriter::flush_chunk() {
  if (chunk_.empty()) return sink_.good();
  const Bytes packed = compressed(chunk_, compression_);
  const std::string compression = name_of(compression_);
  Bytes record;
  append(record, Chunk{chunk_start_time_, chunk_end_time_, chunk_.size(), crc32_of(chunk_), compression, packed});

  ChunkIndex index{chunk_start_time_, chunk_end_time_, sink_.position(), record.size(), {}, 0,
                   compression,       packed.size(),   chunk_.size()};
  if (!sink_.put(record)) return false;
  for (const auto& [channel, messages] : chunk_messages_) {
    index.message_index_offsets[channel] = sink_.position();
    record.clear();
    append(record, messages);
    index.message_index_length += record.size();
    if (!sink_.put(record)) return false;
  }
  chunk_indexes_.push_back(std::move(index));
  chunk_.clear();
  chunk_messages_.clear();
  chunk_start_time_ = chunk_end_time_ = 0;
  return true;
}

bool IndexedWriter::finish() {
  if (!flush_chunk()) return false;
  Bytes end;
  append(end, DataEnd{sink_.crc()});
  return sink_.put(end) && write_summary();
}

bool IndexedWriter::write_summary() {
  statistics_.schema_count = static_cast<std::uint16_t>(schemas_.size());
  statistics_.channel_count = static_cast<std::uint32_t>(channels_.size());
  statistics_.attachment_count = static_cast<std::uint32_t>(attachment_indexes_.size());
  statistics_.metadata_count = static_cast<std::uint32_t>(metadata_indexes_.size());
  statistics_.chunk_count = static_cast<std::uint32_t>(chunk_indexes_.size());

  const std::uint64_t start = sink_.position();
  Bytes summary;
  std::vector<SummaryOffset> offsets;
  append_group(summary, offsets, start, Opcode::Schema, schemas_);
  append_group(summary, offsets, start, Opcode::Channel, channels_);
  append_group(summary, offsets, start, Opcode::Statistics, std::vector<Statistics>{statistics_});
  append_group(summary, offsets, start, Opcode::ChunkIndex, chunk_indexes_);
  append_group(summary, offsets, start, Opcode::AttachmentIndex, attachment_indexes_);
  append_group(summary, offsets, start, Opcode::MetadataIndex, metadata_indexes_);

  Footer footer{start, start + summary.size(), 0};
  for (const SummaryOffset& offset : offsets) append(summary, offset);
  append(summary, footer);
  // The CRC covers the summary and the footer up to the CRC itself.
  footer.summary_crc = crc32_of(ByteView{summary}.first(summary.size() - sizeof(footer.summary_crc)));
  summary.resize(summary.size() - kFooterRecord);
  append(summary, footer);
  summary.insert(summary.end(), std::begin(kMagic), std::end(kMagic));
  return sink_.put(summary);
}

std::uint16_t ChannelTable::channel_of(const std::string& topic, const std::string& schema_name,
                                       std::string_view schema_text, const std::string& message_encoding) {
  if (const auto known = channels_.find(topic); known != channels_.end()) return known->second;
  std::uint16_t schema_id = 0;
  if (!schema_name.empty()) {
    const auto [schema, is_new] = schemas_.emplace(schema_name, static_cast<std::uint16_t>(schemas_.size() + 1));
    schema_id = schema->second;
    if (is_new) writer_.write(Schema{schema_id, schema_name, "omgidl", std::string{schema_text}});
  }
  const auto id = static_cast<std::uint16_t>(channels_.size() + 1);
  channels_.emplace(topic, id);
  writer_.write(Channel{id, schema_id, topic, message_encoding, {}});
  return id;
}

bool ChannelTable::write(std::uint16_t channel, std::uint64_t log_time, std::uint64_t publish_time, ByteView data) {
  return writer_.write(Message{channel, sequences_[channel]++, log_time, publish_time, data});
}

}  // namespace tandem::mcap
