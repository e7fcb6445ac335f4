#include "services/recorder/core/mcap_reader.hpp"

#include <algorithm>
#include <tuple>

#include "services/recorder/core/mcap_chunk.hpp"
#include "services/recorder/core/record_scan.hpp"

namespace tandem::mcap {
namespace {

constexpr std::size_t kOpenChunks = 4;
constexpr std::uint64_t kPiece = 1 << 20;  ///< [bytes] read at once

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

/// The checksum of the first `length` bytes.
std::uint32_t crc32_of_front(ByteSource& source, std::uint64_t length) {
  std::uint32_t crc = 0;
  for (std::uint64_t at = 0; at < length; at += kPiece)
    crc = crc32_of(source.read(at, std::min(kPiece, length - at)), crc);
  return crc;
}

}  // namespace

Reader::Reader(std::unique_ptr<ByteSource> source, std::string name, ReadBy by)
    : source_(std::move(source)), name_(std::move(name)) {
  const Bytes magic = source_->read(0, sizeof(kMagic));
  const bool is_recording = std::equal(magic.begin(), magic.end(), std::begin(kMagic));
  if (!is_recording && by == ReadBy::Summary) throw McapError(name_ + ": is not a recording (no MCAP file)");
  if (!is_recording) note_damage(0, "the file does not begin as a recording does");
  const bool has_summary = open_by_summary();
  if (!has_summary || by == ReadBy::Records) {
    forget_all();
    open_by_scanning(is_recording ? sizeof(kMagic) : 0);
  }
  if (!is_recording && entries_.empty()) throw McapError(name_ + ": is not a recording, and holds no record of one");
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
  return read_summary(ByteView{summary}.first(records));
}

void Reader::forget_all() {
  schemas_.clear();
  channels_.clear();
  chunks_.clear();
  entries_.clear();
  attachments_.clear();
  metadata_.clear();
}

bool Reader::read_summary(ByteView summary) {
  bool good = true;
  std::optional<std::uint64_t> promised;  // without statistics nobody says whether the index is all
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
  const bool all_named = std::all_of(entries_.begin(), entries_.end(),
                                     [this](const Entry& entry) { return channels_.contains(entry.channel_id); });
  return good && all_named && promised == entries_.size();
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
    for (const auto& [time, offset] : index->entries) entries_.push_back({time, number, index->channel_id, offset});
  });
}

void Reader::open_by_scanning(std::uint64_t start) {
  RecordScan scan{*source_, start,
                  [this](std::uint64_t offset, const std::string& what) { note_damage(offset, what); }};
  bool in_summary = false;  // where schemas and channels stand once more
  while (const auto record = scan.next()) {
    if (record->opcode == Opcode::DataEnd) {
      check_data_section(*record);
      in_summary = true;
    } else if (!in_summary || record->opcode == Opcode::Schema || record->opcode == Opcode::Channel) {
      scan_record(record->opcode, {record->offset, record->content.size()}, record->content);
    }
  }
  if (closed_ && !in_summary) note_damage(scan.offset(), "the end of the data is missing, though the file was closed");
  name_lost_channels();
}

void Reader::check_data_section(const FoundRecord& record) {
  const auto end = parse<DataEnd>(record.content);
  if (!end || end->data_section_crc == 0 || !damages_.empty()) return;
  if (end->data_section_crc != crc32_of_front(*source_, record.offset)) {
    note_damage(record.offset, "the checksum of all before is wrong");
  }
}

void Reader::name_lost_channels() {
  for (const Entry& entry : entries_) {
    if (channels_.contains(entry.channel_id)) continue;
    const std::string topic = "lost_channel_" + std::to_string(entry.channel_id);
    channels_[entry.channel_id] = {entry.channel_id, 0, topic, "", {}};
    note_damage(entry.chunk == kNoChunk ? entry.offset : chunks_[entry.chunk].offset,
                "the channel of this message is lost; it is named " + topic);
  }
  for (auto& [id, channel] : channels_) {
    if (channel.schema_id == 0 || schemas_.contains(channel.schema_id)) continue;
    note_damage(0, "the schema of " + channel.topic + " is lost");
    channel.schema_id = 0;
  }
}

void Reader::scan_record(Opcode opcode, Place place, ByteView content) {
  if (opcode == Opcode::Schema) {
    if (auto schema = parse<Schema>(content)) schemas_.try_emplace(schema->id, std::move(*schema));
  } else if (opcode == Opcode::Channel) {
    if (auto channel = parse<Channel>(content)) channels_.try_emplace(channel->id, std::move(*channel));
  } else if (opcode == Opcode::Message) {
    if (const auto message = parse<Message>(content)) {
      entries_.push_back({message->log_time, kNoChunk, message->channel_id, place.offset});
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
        entries_.push_back({message->log_time, number, message->channel_id, offset});
    } else if (opcode == Opcode::Schema || opcode == Opcode::Channel) {
      scan_record(opcode, place, inner);
    }
  });
  if (!whole) note_damage(place.offset, "a chunk ends inside a record");
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
