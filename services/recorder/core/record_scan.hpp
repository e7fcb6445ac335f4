#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>

#include "services/recorder/core/byte_source.hpp"

namespace tandem::mcap {

/// Opcode and content length at the front of a record.
struct RecordHead {
  Opcode opcode{};
  std::uint64_t length = 0;
};

/// The head at the front of `bytes`, which has at least kRecordHead of them.
[[nodiscard]] RecordHead head_of(ByteView bytes);

/// A whole record of a file.
struct FoundRecord {
  Opcode opcode{};
  std::uint64_t offset = 0;  ///< of the record
  ByteView content;          ///< valid until the next record is looked for
};

/// Goes through a file that may be damaged anywhere, from record to record.
///
/// Nothing in a record guards its opcode and length, so a record is believed only if another follows it, or if its own
/// checksum proves it. Otherwise the file is searched, byte by byte, for the next place where records begin: a damaged
/// one costs itself and nothing behind it. A file that ends inside a record, as it does when its writer was killed,
/// ends at the last whole one without a word.
class RecordScan {
 public:
  using OnDamage = std::function<void(std::uint64_t offset, const std::string& what)>;

  /// Begins at byte `start`. `on_damage` is told of what is passed over.
  RecordScan(ByteSource& source, std::uint64_t start, OnDamage on_damage);

  /// The next whole record; none at the end.
  [[nodiscard]] std::optional<FoundRecord> next();
  /// Where the next one is looked for.
  [[nodiscard]] std::uint64_t offset() const { return offset_; }

 private:
  /// Bytes of the source, read ahead.
  struct Window {
    Bytes bytes;
    std::uint64_t at = 0;
  };
  [[nodiscard]] ByteView bytes_at(Window& window, std::uint64_t from, std::uint64_t length, std::uint64_t read_ahead);
  /// The head of the record at `offset`, if one with a known opcode fits there.
  [[nodiscard]] std::optional<RecordHead> head_at(std::uint64_t offset);
  [[nodiscard]] ByteView content_at(std::uint64_t offset, const RecordHead& head);
  /// The head at `offset`, if its content can be that of such a record.
  [[nodiscard]] std::optional<RecordHead> record_at(std::uint64_t offset);
  [[nodiscard]] bool opcode_is_known_at(std::uint64_t offset);
  [[nodiscard]] bool is_opcode_at(std::uint64_t offset, Opcode opcode);
  /// Whether at `offset` there is a record, or the end.
  [[nodiscard]] bool a_record_follows(std::uint64_t offset);
  [[nodiscard]] bool proves_itself(std::uint64_t offset, const RecordHead& head);
  [[nodiscard]] bool is_like_those_before(std::uint64_t offset, const RecordHead& head);
  [[nodiscard]] std::optional<std::uint64_t> next_place_after(std::uint64_t offset);
  /// Whether there is nothing but whole records, and then one that is damaged: what stands in front of them ends there.
  [[nodiscard]] bool ends_in_one_damaged_record(std::uint64_t from, std::uint64_t to);
  /// Either opcode or length is still what it was (but for a bit), or both are erased.
  [[nodiscard]] bool is_one_damaged_record(std::uint64_t from, std::uint64_t to);
  [[nodiscard]] FoundRecord take(const RecordHead& head);

  ByteSource& source_;
  OnDamage on_damage_;
  std::uint64_t offset_;
  Window peeked_;
  Window content_;
  Window follower_;
  std::set<std::uint16_t> channels_;  ///< of the records taken
  bool is_chunked_ = false;           ///< then what looks like a message lies inside a chunk that is damaged
  std::uint64_t last_log_time_ = 0;   ///< of the messages taken [ns]
};

}  // namespace tandem::mcap
