#include "services/recorder/core/record_scan.hpp"

#include <algorithm>
#include <bit>

#include "services/recorder/core/mcap_chunk.hpp"

namespace tandem::mcap {
namespace {

constexpr std::uint64_t kPeekAhead = 4 << 10;
constexpr std::uint64_t kContentAhead = 1 << 20;
constexpr std::uint64_t kLongestSilence = 600'000'000'000;  ///< [ns] between neighbours, where one was searched for
constexpr std::uint8_t kFirstPrivateOpcode = 0x80;
constexpr std::uint64_t kMessageFields = 2 + 4 + 8 + 8;
constexpr std::uint64_t kAttachmentFields = 8 + 8 + 4 + 4 + 8 + 4;
constexpr std::uint64_t kSummaryOffsetFields = 1 + 8 + 8;

bool is_of_the_specification(Opcode opcode) {
  return opcode >= Opcode::Header && opcode <= Opcode::DataEnd;
}

bool is_kept_in_chunks(Opcode opcode) {
  return opcode == Opcode::Schema || opcode == Opcode::Channel || opcode == Opcode::Message;
}

bool is_known(Opcode opcode) {
  return is_of_the_specification(opcode) || static_cast<std::uint8_t>(opcode) >= kFirstPrivateOpcode;
}

/// Whether `content` can be that of a record of kind `opcode`.
bool is_content_of(Opcode opcode, ByteView content) {
  switch (opcode) {
    case Opcode::Header:
      return parse<Header>(content).has_value();
    case Opcode::Footer:
      return parse<Footer>(content).has_value();
    case Opcode::Schema:
      return parse<Schema>(content).has_value();
    case Opcode::Channel:
      return parse<Channel>(content).has_value();
    case Opcode::Message:
      return content.size() >= kMessageFields;
    case Opcode::Chunk:
      return parse<Chunk>(content).has_value();
    case Opcode::MessageIndex:
      return parse<MessageIndex>(content).has_value();
    case Opcode::ChunkIndex:
      return parse<ChunkIndex>(content).has_value();
    case Opcode::AttachmentIndex:
      return parse<AttachmentIndex>(content).has_value();
    case Opcode::Statistics:
      return parse<Statistics>(content).has_value();
    case Opcode::Metadata:
      return parse<Metadata>(content).has_value();
    case Opcode::MetadataIndex:
      return parse<MetadataIndex>(content).has_value();
    case Opcode::DataEnd:
      return parse<DataEnd>(content).has_value();
    case Opcode::Attachment:  // its checksum is judged where it is used
      return content.size() >= kAttachmentFields;
    case Opcode::SummaryOffset:
      return content.size() >= kSummaryOffsetFields;
  }
  return true;  // private to another program
}

}  // namespace

RecordHead head_of(ByteView bytes) {
  RecordHead head{static_cast<Opcode>(bytes[0]), 0};
  for (std::size_t i = 0; i < 8; ++i) head.length |= static_cast<std::uint64_t>(bytes[1 + i]) << (8 * i);
  return head;
}

RecordScan::RecordScan(ByteSource& source, std::uint64_t start, OnDamage on_damage)
    : source_(source), on_damage_(std::move(on_damage)), offset_(start) {}

ByteView RecordScan::bytes_at(Window& window, std::uint64_t from, std::uint64_t length, std::uint64_t read_ahead) {
  if (from < window.at || from + length > window.at + window.bytes.size()) {
    window.bytes = source_.read(from, std::max(length, read_ahead));
    window.at = from;
  }
  return ByteView{window.bytes}.subspan(static_cast<std::size_t>(from - window.at), static_cast<std::size_t>(length));
}

std::optional<RecordHead> RecordScan::head_at(std::uint64_t offset) {
  if (source_.size() < kRecordHead || offset > source_.size() - kRecordHead) return std::nullopt;
  const RecordHead head = head_of(bytes_at(peeked_, offset, kRecordHead, kPeekAhead));
  if (!is_known(head.opcode) || head.length > source_.size() - offset - kRecordHead) return std::nullopt;
  return head;
}

ByteView RecordScan::content_at(std::uint64_t offset, const RecordHead& head) {
  return bytes_at(content_, offset + kRecordHead, head.length, kContentAhead);
}

std::optional<RecordHead> RecordScan::record_at(std::uint64_t offset) {
  const auto head = head_at(offset);
  return head && is_content_of(head->opcode, content_at(offset, *head)) ? head : std::nullopt;
}

bool RecordScan::opcode_is_known_at(std::uint64_t offset) {
  return is_known(static_cast<Opcode>(bytes_at(peeked_, offset, 1, kPeekAhead)[0]));
}

bool RecordScan::is_opcode_at(std::uint64_t offset, Opcode opcode) {
  return offset < source_.size() && static_cast<Opcode>(bytes_at(peeked_, offset, 1, kPeekAhead)[0]) == opcode;
}

bool RecordScan::a_record_follows(std::uint64_t offset) {
  if (offset == source_.size()) return true;
  if (source_.size() - offset < kRecordHead) return opcode_is_known_at(offset);  // cut off, or the closing magic
  const auto head = head_at(offset);
  return head && is_content_of(head->opcode, bytes_at(follower_, offset + kRecordHead, head->length, kContentAhead));
}

bool RecordScan::proves_itself(std::uint64_t offset, const RecordHead& head) {
  if (head.opcode == Opcode::Chunk) {
    return std::holds_alternative<Bytes>(records_in_chunk(content_at(offset, head)));
  }
  return head.opcode == Opcode::Attachment && parse<Attachment>(content_at(offset, head)).has_value();
}

bool RecordScan::is_like_those_before(std::uint64_t offset, const RecordHead& head) {
  if (head.opcode != Opcode::Message) return false;
  const auto message = parse<Message>(content_at(offset, head));
  return message && channels_.contains(message->channel_id) &&
         std::max(message->log_time, last_log_time_) - std::min(message->log_time, last_log_time_) < kLongestSilence;
}

std::optional<std::uint64_t> RecordScan::next_place_after(std::uint64_t offset) {
  for (std::uint64_t place = offset + 1; place + kRecordHead <= source_.size(); ++place) {
    const auto opcode = static_cast<Opcode>(bytes_at(peeked_, place, kRecordHead, kPeekAhead)[0]);
    if (!is_of_the_specification(opcode) || (is_chunked_ && is_kept_in_chunks(opcode))) continue;
    const auto head = record_at(place);
    if (!head) continue;
    if (a_record_follows(place + kRecordHead + head->length) || proves_itself(place, *head) ||
        is_like_those_before(place, *head)) {
      return place;
    }
  }
  return std::nullopt;
}

bool RecordScan::ends_in_one_damaged_record(std::uint64_t from, std::uint64_t to) {
  while (from != to && !is_one_damaged_record(from, to)) {
    const auto whole = record_at(from);
    if (!whole || kRecordHead + whole->length > to - from) return false;
    from += kRecordHead + whole->length;
  }
  return true;
}

bool RecordScan::is_one_damaged_record(std::uint64_t from, std::uint64_t to) {
  if (to - from < kRecordHead) return false;
  const RecordHead head = head_of(bytes_at(peeked_, from, kRecordHead, kPeekAhead));
  const std::uint64_t length = to - from - kRecordHead;
  const bool is_erased = head.opcode == Opcode{0} && head.length == 0;
  return is_erased || head.length == length ||
         (is_of_the_specification(head.opcode) && std::has_single_bit(head.length ^ length));
}

FoundRecord RecordScan::take(const RecordHead& head) {
  const FoundRecord found{head.opcode, offset_, content_at(offset_, head)};
  if (head.opcode == Opcode::Chunk) {
    is_chunked_ = true;
  } else if (head.opcode == Opcode::Channel) {
    if (const auto channel = parse<Channel>(found.content)) channels_.insert(channel->id);
  } else if (head.opcode == Opcode::Message) {
    if (const auto message = parse<Message>(found.content)) last_log_time_ = message->log_time;
  }
  offset_ += kRecordHead + head.length;
  return found;
}

std::optional<FoundRecord> RecordScan::next() {
  while (offset_ + kRecordHead <= source_.size()) {
    const auto head = record_at(offset_);
    const std::uint64_t end = head ? offset_ + kRecordHead + head->length : offset_;
    if (head && (a_record_follows(end) || proves_itself(offset_, *head))) return take(*head);

    is_chunked_ = is_chunked_ || is_opcode_at(offset_, Opcode::Chunk) || is_opcode_at(end, Opcode::Chunk);
    const auto resume = next_place_after(offset_);
    if (!resume) {
      if (head) return take(*head);  // the last; behind it the writer was killed
      if (!opcode_is_known_at(offset_)) on_damage_(offset_, "no record begins here");
      offset_ = source_.size();
      return std::nullopt;
    }
    if (head && end <= *resume && ends_in_one_damaged_record(end, *resume)) return take(*head);
    on_damage_(offset_, "a record is damaged; it goes on at byte " + std::to_string(*resume));
    offset_ = *resume;
  }
  return std::nullopt;
}

}  // namespace tandem::mcap
