#include "services/recorder/core/mcap_reader.hpp"

#include <algorithm>
#include <tuple>

#include "services/recorder/core/mcap_chunk.hpp"

namespace tandem::mcap {
namespace {

constexpr std::size_t kOpenChunks = 4;
constexpr std::uint64_t kReadAhead = 1 << 20;

struct RecordHead {
  Opcode opcode{};
  std::uint64_t length = 0;
};

/// The opcode and content length at the front of `bytes`, which has at least kRecordHead of them.
RecordHead head_of(ByteView bytes) {
  RecordHead head{static_cast<Opcode>(bytes[0]), 0};
  for (std::size_t i = 0; i < 8; ++i) head.length |= static_cast<std::uint64_t>(bytes[1 + i]) << (8 * i);
  return head;
}

/// Calls `visit(opcode, offset, content)` for each whole record in `bytes`. False if something else follows them.
template <typename Visit>
bool for_each_record(ByteView bytes, Visit visit) {
  std::size_t offset = 0;
  while (offset < bytes.size()) {
    if (bytes.size() - offset < kRecordHead) return false;
    const RecordHead head = head_of(bytes.subspan(offset));
    if (head.length > bytes.size() - offset - kRecordHead) return false;
    visit(head.opcode, offset, bytes.subspan(offset + kRecordHead, static_cast<std::size_t>(head.length)));
    offset += kRecordHead + static_cast<std::size_t>(head.length);
  }
  return true;
}

}  // namespace

Reader::Reader(std::unique_ptr<ByteSource> source, std::string name)
    : source_(std::move(source)), name_(std::move(name)) {
  const Bytes magic = source_->read(0, sizeof(kMagic));
  if (!std::equal(magic.begin(), magic.end(), std::begin(kMagic))) {
    throw McapError(name_ + ": is not a recording (no MCAP file)");
  }
  if (!open_by_summary()) open_by_scanning();
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.log_time, a.chunk, a.offset) < std::tie(b.log_time, b.chunk, b.offset);
  });
}

void Reader::note_damage(std::uint64_t offset, const std::string& what) {
  damages_.push_back(name_ + ": byte " + std::to_string(offset) + ": " + what);
}

bool Reader::open_by_summary() {
  const std::uint64_t tail = kFooterRecord + sizeof(kMagic);
  if (source_->size() < sizeof(kMagic) + tail) return false;
  const std::uint64_t footer_at = source_->size() - tail;
  const Bytes end = source_->read(footer_at, tail);
  if (!std::equal(std::begin(kMagic), std::end(kMagic), end.begin() + kFooterRecord)) return false;
  const RecordHead head = head_of(end);
  if (head.opcode != Opcode::Footer || head.length != kFooterRecord - kRecordHead) return false;
  const auto footer = parse<Footer>(ByteView{end}.subspan(kRecordHead, static_cast<std::size_t>(head.length)));
  closed_ = true;
  if (!footer || footer->summary_start == 0 || footer->summary_start > footer_at) return false;

  Bytes summary = source_->read(footer->summary_start, footer_at - footer->summary_start);
  const std::size_t records = summary.size();
  summary.insert(summary.end(), end.begin(), end.begin() + (kFooterRecord - 4));
  if (footer->summary_crc != 0 && crc32_of(summary) != footer->summary_crc) {
    note_damage(footer->summary_start, "the summary is damaged; read without it");
    return false;
  }
  if (read_summary(ByteView{summary}.first(records))) return true;
  schemas_.clear();
  channels_.clear();
  chunks_.clear();
  entries_.clear();
  attachments_.clear();
  metadata_.clear();
  return false;
}

bool Reader::read_summary(ByteView summary) {
  bool good = true;
  std::uint64_t promised = 0;
  std::vector<ChunkIndex> chunks;
  good = for_each_record(summary, [&](Opcode opcode, std::size_t, ByteView content) {
    if (opcode == Opcode::Schema) {
      if (auto schema = parse<Schema>(content)) schemas_[schema->id] = std::move(*schema);
    } else if (opcode == Opcode::Channel) {
      if (auto channel = parse<Channel>(content)) channels_[channel->id] = std::move(*channel);
    } else if (opcode == Opcode::Statistics) {
      if (const auto statistics = parse<Statistics>(content)) promised = statistics->message_count;
    } else if (opcode == Opcode::ChunkIndex) {
      if (auto chunk = parse<ChunkIndex>(content)) chunks.push_back(std::move(*chunk));
    } else if (opcode == Opcode::AttachmentIndex) {
      if (const auto index = parse<AttachmentIndex>(content)) attachments_.push_back(index->offset);
    } else if (opcode == Opcode::MetadataIndex) {
      if (const auto index = parse<MetadataIndex>(content)) metadata_.push_back(index->offset);
    }
  });
  for (const ChunkIndex& chunk : chunks) good = good && read_message_indexes(chunk);
  return good && entries_.size() == promised;
}

bool Reader::read_message_indexes(const ChunkIndex& chunk) {
  if (chunk.chunk_length < kRecordHead || chunk.message_index_length > source_->size()) return false;
  const auto number = static_cast<std::uint32_t>(chunks_.size());
  chunks_.push_back({chunk.chunk_offset, chunk.chunk_length - kRecordHead});
  const Bytes indexes = source_->read(chunk.chunk_offset + chunk.chunk_length, chunk.message_index_length);
  return for_each_record(indexes, [&](Opcode opcode, std::size_t, ByteView content) {
    if (opcode != Opcode::MessageIndex) return;
    const auto index = parse<MessageIndex>(content);
    if (!index) return;
    for (const auto& [time, offset] : index->entries) add_message({time, number, index->channel_id, offset});
  });
}

void Reader::open_by_scanning() {
  std::uint64_t offset = sizeof(kMagic);
  Bytes window;
  std::uint64_t window_at = offset;
  const auto bytes_at = [&](std::uint64_t from, std::uint64_t length) {
    if (from < window_at || from + length > window_at + window.size()) {
      window = source_->read(from, std::max(length, kReadAhead));
      window_at = from;
    }
    return ByteView{window}.subspan(static_cast<std::size_t>(from - window_at), static_cast<std::size_t>(length));
  };
  std::uint32_t crc = crc32_of(kMagic);
  while (offset + kRecordHead <= source_->size()) {
    const RecordHead head = head_of(bytes_at(offset, kRecordHead));
    if (head.length > source_->size() - offset - kRecordHead) break;  // the writer was killed here
    const Place place{offset, head.length};
    const ByteView record = bytes_at(offset, kRecordHead + head.length);
    const ByteView content = record.subspan(kRecordHead);
    if (head.opcode == Opcode::DataEnd) {
      const auto end = parse<DataEnd>(content);
      if (end && end->data_section_crc != 0 && end->data_section_crc != crc) {
        note_damage(offset, "the checksum of all before is wrong");
      }
      return;
    }
    if (head.opcode == Opcode{0}) {
      note_damage(offset, "no record begins here");
      return;
    }
    scan_record(head.opcode, place, content);
    crc = crc32_of(record, crc);
    offset += record.size();
  }
  if (closed_) note_damage(offset, "no record begins here, though the file was closed");
}

void Reader::scan_record(Opcode opcode, Place place, ByteView content) {
  if (opcode == Opcode::Schema) {
    if (auto schema = parse<Schema>(content)) schemas_[schema->id] = std::move(*schema);
  } else if (opcode == Opcode::Channel) {
    if (auto channel = parse<Channel>(content)) channels_[channel->id] = std::move(*channel);
  } else if (opcode == Opcode::Message) {
    if (const auto message = parse<Message>(content)) {
      add_message({message->log_time, kNoChunk, message->channel_id, place.offset});
    } else {
      note_damage(place.offset, "a message is damaged");
    }
  } else if (opcode == Opcode::Chunk) {
    scan_chunk(place, content);
  } else if (opcode == Opcode::Attachment) {
    attachments_.push_back(place.offset);
  } else if (opcode == Opcode::Metadata) {
    metadata_.push_back(place.offset);
  }
}

void Reader::scan_chunk(Place place, ByteView content) {
  const auto number = static_cast<std::uint32_t>(chunks_.size());
  chunks_.push_back(place);
  const auto records = unpacked(place, content);
  if (!records) return;
  const bool whole = for_each_record(*records, [&](Opcode opcode, std::size_t offset, ByteView inner) {
    if (opcode == Opcode::Message) {
      if (const auto message = parse<Message>(inner))
        add_message({message->log_time, number, message->channel_id, offset});
    } else if (opcode == Opcode::Schema || opcode == Opcode::Channel) {
      scan_record(opcode, place, inner);
    }
  });
  if (!whole) note_damage(place.offset, "a chunk ends inside a record");
}

void Reader::add_message(const Entry& entry) {
  if (channels_.contains(entry.channel_id)) {
    entries_.push_back(entry);
  } else {
    note_damage(entry.chunk == kNoChunk ? entry.offset : chunks_[entry.chunk].offset,
                "a message of the unknown channel " + std::to_string(entry.channel_id));
  }
}

std::optional<Bytes> Reader::unpacked(const Place& place, ByteView content) {
  auto records = records_in_chunk(content);
  if (const auto* damage = std::get_if<ChunkDamage>(&records)) {
    note_damage(place.offset, damage->what);
    return std::nullopt;
  }
  return std::get<Bytes>(std::move(records));
}

std::optional<Bytes> Reader::content_at(std::uint64_t offset, Opcode expected) {
  if (offset + kRecordHead > source_->size()) return std::nullopt;
  const RecordHead head = head_of(source_->read(offset, kRecordHead));
  if (head.opcode != expected || head.length > source_->size() - offset - kRecordHead) return std::nullopt;
  return source_->read(offset + kRecordHead, head.length);
}

const Bytes* Reader::records_of(std::uint32_t chunk) {
  const auto open = std::find_if(open_chunks_.begin(), open_chunks_.end(),
                                 [chunk](const OpenChunk& candidate) { return candidate.chunk == chunk; });
  if (open != open_chunks_.end()) {
    open_chunks_.splice(open_chunks_.begin(), open_chunks_, open);
  } else {
    std::optional<Bytes> records;
    if (const auto content = content_at(chunks_[chunk].offset, Opcode::Chunk)) {
      records = unpacked(chunks_[chunk], *content);
    } else {
      note_damage(chunks_[chunk].offset, "no chunk is here, against the index");
    }
    open_chunks_.push_front({chunk, records.value_or(Bytes{})});  // a damaged one is remembered as empty
    if (open_chunks_.size() > kOpenChunks) open_chunks_.pop_back();
  }
  return open_chunks_.front().records.empty() ? nullptr : &open_chunks_.front().records;
}

std::optional<Message> Reader::message_at(std::size_t index) {
  const Entry& entry = entries_[index];
  const bool in_chunk = entry.chunk != kNoChunk;
  const Bytes* records = in_chunk ? records_of(entry.chunk) : nullptr;
  if (in_chunk && records == nullptr) return std::nullopt;  // noted when the chunk was opened
  std::optional<Message> message;
  if (!in_chunk) {
    message_ = content_at(entry.offset, Opcode::Message).value_or(Bytes{});
    message = parse<Message>(message_);
  } else if (entry.offset < records->size() && records->size() - entry.offset >= kRecordHead) {
    const ByteView rest = ByteView{*records}.subspan(static_cast<std::size_t>(entry.offset));
    const RecordHead head = head_of(rest);
    if (head.opcode == Opcode::Message && head.length <= rest.size() - kRecordHead) {
      message = parse<Message>(rest.subspan(kRecordHead, static_cast<std::size_t>(head.length)));
    }
  }
  if (!message || message->log_time != entry.log_time || message->channel_id != entry.channel_id) {
    note_damage(in_chunk ? chunks_[entry.chunk].offset : entry.offset, "a message is not where the index says");
    return std::nullopt;
  }
  return message;
}

const Channel* Reader::channel_of(const std::string& topic) const {
  for (const auto& [id, channel] : channels_) {
    if (channel.topic == topic) return &channel;
  }
  return nullptr;
}

std::vector<Attachment> Reader::attachments() {
  std::vector<Attachment> all;
  for (const std::uint64_t offset : attachments_) {
    const auto content = content_at(offset, Opcode::Attachment);
    auto attachment = content ? parse<Attachment>(*content) : std::nullopt;
    if (attachment) {
      all.push_back(std::move(*attachment));
    } else {
      note_damage(offset, "an attachment is damaged");
    }
  }
  return all;
}

std::vector<Metadata> Reader::metadata() {
  std::vector<Metadata> all;
  for (const std::uint64_t offset : metadata_) {
    const auto content = content_at(offset, Opcode::Metadata);
    if (auto metadata = content ? parse<Metadata>(*content) : std::nullopt) all.push_back(std::move(*metadata));
  }
  return all;
}

}  // namespace tandem::mcap
