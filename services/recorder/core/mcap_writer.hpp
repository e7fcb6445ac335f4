#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "services/recorder/core/mcap_compression.hpp"
#include "services/recorder/core/mcap_records.hpp"

namespace tandem::mcap {

/// Where a writer's bytes go: one whole record (or the opening of the file) a call. False: not kept; a writer stops
/// then.
using Sink = std::function<bool(ByteView)>;

/// Writes one MCAP file from front to back. Schemas come before their channels, channels before their messages.
///
/// Every write() is false once the sink has refused a record: what was written before is a readable file.
class Writer {
 public:
  virtual ~Writer() = default;
  virtual bool write(const Schema& schema) = 0;
  virtual bool write(const Channel& channel) = 0;
  virtual bool write(const Message& message) = 0;
  virtual bool write(const Attachment& attachment) = 0;
  virtual bool write(const Metadata& metadata) = 0;
  /// The last thing written. Nothing may follow.
  virtual bool finish() = 0;
};

/// Counts and checks what passes to a Sink; both writers stand on it.
class CheckedSink {
 public:
  explicit CheckedSink(Sink sink) : sink_(std::move(sink)) {}
  bool put(ByteView bytes);
  [[nodiscard]] std::uint64_t position() const { return position_; }
  [[nodiscard]] std::uint32_t crc() const { return crc_; }
  [[nodiscard]] bool good() const { return good_; }

 private:
  Sink sink_;
  std::uint64_t position_ = 0;
  std::uint32_t crc_ = 0;
  bool good_ = true;
};

/// Without chunks, each record handed to the sink as soon as it is written: a file whose writer was killed holds all of
/// them. finish() closes it without an index; see compact().
class LiveWriter final : public Writer {
 public:
  LiveWriter(Sink sink, const Header& header);
  bool write(const Schema& schema) override;
  bool write(const Channel& channel) override;
  bool write(const Message& message) override;
  bool write(const Attachment& attachment) override;
  bool write(const Metadata& metadata) override;
  bool finish() override;

 private:
  template <typename Record>
  bool put(const Record& record);
  CheckedSink sink_;
  Bytes buffer_;
};

/// In compressed chunks with message indexes, and at the end a summary that finds everything.
class IndexedWriter final : public Writer {
 public:
  IndexedWriter(Sink sink, const Header& header, std::size_t chunk_size = 1 << 20,
                Compression compression = Compression::Zstd);
  bool write(const Schema& schema) override;
  bool write(const Channel& channel) override;
  bool write(const Message& message) override;
  bool write(const Attachment& attachment) override;
  bool write(const Metadata& metadata) override;
  bool finish() override;

 private:
  bool flush_chunk();
  bool write_summary();

  CheckedSink sink_;
  std::size_t chunk_size_;
  Compression compression_;
  Bytes chunk_;  ///< the records of the chunk to come
  std::map<std::uint16_t, MessageIndex> chunk_messages_;
  std::uint64_t chunk_start_time_ = 0;
  std::uint64_t chunk_end_time_ = 0;
  std::vector<Schema> schemas_;
  std::vector<Channel> channels_;
  std::vector<ChunkIndex> chunk_indexes_;
  std::vector<AttachmentIndex> attachment_indexes_;
  std::vector<MetadataIndex> metadata_indexes_;
  Statistics statistics_;
};

/// Gives each topic its channel and each type its schema, on the first use of each.
class ChannelTable {
 public:
  explicit ChannelTable(Writer& writer) : writer_(writer) {}
  /// The channel of `topic`, CDR messages of the type `schema_name`, whose IDL is `schema_text`. With an empty
  /// `schema_name` the channel has no schema.
  [[nodiscard]] std::uint16_t channel_of(const std::string& topic, const std::string& schema_name,
                                         std::string_view schema_text, const std::string& message_encoding = "cdr");
  /// Writes `data` as the next message of `channel`.
  bool write(std::uint16_t channel, std::uint64_t log_time, std::uint64_t publish_time, ByteView data);

 private:
  Writer& writer_;
  std::map<std::string, std::uint16_t> schemas_;
  std::map<std::string, std::uint16_t> channels_;
  std::map<std::uint16_t, std::uint32_t> sequences_;
};

}  // namespace tandem::mcap
