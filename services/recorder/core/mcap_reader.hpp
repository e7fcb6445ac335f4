#pragma once

#include <list>
#include <memory>
#include <string>
#include <vector>

#include "services/recorder/core/byte_source.hpp"
#include "services/recorder/core/mcap_records.hpp"

namespace tandem::mcap {

struct FoundRecord;

/// How a recording is opened.
enum class ReadBy {
  Summary,  ///< by the index at its end where there is one
  Records,  ///< going through all of it, whatever the index says: for what is damaged
};

/// Reads an MCAP file by its index; a file without one (still being written, or its writer was killed) by going through
/// it once. It opens up to the last whole record, past what is damaged (record_scan.hpp); complete() tells.
class Reader {
 public:
  /// Throws McapError when `source` is no MCAP file at all; `name` stands in messages.
  Reader(std::unique_ptr<ByteSource> source, std::string name, ReadBy by = ReadBy::Summary);

  /// True if the writer closed the file and nothing damaged was met so far.
  [[nodiscard]] bool complete() const { return closed_ && damages_.empty(); }
  /// What could not be read, each with its place in the file.
  [[nodiscard]] const std::vector<std::string>& damages() const { return damages_; }

  [[nodiscard]] const std::map<std::uint16_t, Schema>& schemas() const { return schemas_; }
  [[nodiscard]] const std::map<std::uint16_t, Channel>& channels() const { return channels_; }
  /// The channel of `topic`, or null.
  [[nodiscard]] const Channel* channel_of(const std::string& topic) const;

  /// Messages, ordered by log time, in file order where that is equal.
  [[nodiscard]] std::size_t message_count() const { return entries_.size(); }
  [[nodiscard]] std::uint16_t channel_at(std::size_t index) const { return entries_[index].channel_id; }
  [[nodiscard]] std::uint64_t log_time_at(std::size_t index) const { return entries_[index].log_time; }
  /// The message at `index`, none where the file is damaged. Its data is valid until the next call.
  [[nodiscard]] std::optional<Message> message_at(std::size_t index);

  [[nodiscard]] std::vector<Attachment> attachments();
  [[nodiscard]] std::vector<Metadata> metadata();

 private:
  /// A message: in chunk `chunk` at `offset` of its records, or, with kNoChunk, in the file.
  struct Entry {
    std::uint64_t log_time = 0;
    std::uint32_t chunk = 0;
    std::uint16_t channel_id = 0;
    std::uint64_t offset = 0;
  };
  struct Place {
    std::uint64_t offset = 0;  ///< of the record
    std::uint64_t length = 0;  ///< of its content
  };
  struct OpenChunk {
    std::uint32_t chunk = 0;
    Bytes records;
  };
  static constexpr std::uint32_t kNoChunk = 0xFFFFFFFF;

  [[nodiscard]] bool open_by_summary();
  [[nodiscard]] bool read_summary(ByteView summary);
  [[nodiscard]] bool read_message_indexes(const ChunkIndex& chunk);
  void forget_all();
  void open_by_scanning(std::uint64_t start);
  void check_data_section(const FoundRecord& end);
  /// Messages whose channel was damaged get one with a made-up name, so that they are not lost with it.
  void name_lost_channels();
  void scan_record(Opcode opcode, Place place, ByteView content);
  void scan_chunk(Place place, ByteView content);
  /// The records of `chunk`, or null after noting why not.
  [[nodiscard]] const Bytes* records_of(std::uint32_t chunk);
  [[nodiscard]] std::optional<Bytes> unpacked(const Place& place, ByteView content);
  [[nodiscard]] std::optional<Bytes> content_at(std::uint64_t offset, Opcode expected);
  void note_damage(std::uint64_t offset, const std::string& what);

  std::unique_ptr<ByteSource> source_;
  std::string name_;
  bool closed_ = false;
  std::vector<std::string> damages_;
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, Channel> channels_;
  std::vector<Place> chunks_;
  std::vector<Entry> entries_;
  std::vector<std::uint64_t> attachments_;  ///< offsets of their records
  std::vector<std::uint64_t> metadata_;
  std::list<OpenChunk> open_chunks_;  ///< the last used first
  Bytes message_;                     ///< of the last message_at() outside a chunk
};

}  // namespace tandem::mcap
