#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

/// The MCAP container (https://mcap.dev/spec): its records as values, and their bytes.
namespace tandem::mcap {

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

/// A file that is not what it should be; what() says where.
class McapError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class Opcode : std::uint8_t {
  Header = 0x01,
  Footer = 0x02,
  Schema = 0x03,
  Channel = 0x04,
  Message = 0x05,
  Chunk = 0x06,
  MessageIndex = 0x07,
  ChunkIndex = 0x08,
  Attachment = 0x09,
  AttachmentIndex = 0x0A,
  Statistics = 0x0B,
  Metadata = 0x0C,
  MetadataIndex = 0x0D,
  SummaryOffset = 0x0E,
  DataEnd = 0x0F,
};

inline constexpr std::uint8_t kMagic[8] = {0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
inline constexpr std::size_t kRecordHead = 9;                          ///< opcode and length of each record
inline constexpr std::size_t kFooterRecord = kRecordHead + 8 + 8 + 4;  ///< bytes of a whole Footer record

struct Header {
  std::string profile;
  std::string library;
};
struct Schema {
  std::uint16_t id = 0;  ///< from 1; a channel with schema 0 has none
  std::string name;
  std::string encoding;
  std::string text;
};
struct Channel {
  std::uint16_t id = 0;
  std::uint16_t schema_id = 0;
  std::string topic;
  std::string message_encoding;
  std::map<std::string, std::string> metadata;
};
struct Message {
  std::uint16_t channel_id = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time = 0;      ///< when it was recorded [ns]
  std::uint64_t publish_time = 0;  ///< when it was sent [ns]
  ByteView data;                   ///< valid as long as the reader says
};
struct Chunk {
  std::uint64_t start_time = 0;
  std::uint64_t end_time = 0;
  std::uint64_t uncompressed_size = 0;
  std::uint32_t uncompressed_crc = 0;  ///< 0: none
  std::string compression;             ///< "", "zstd" or "lz4"
  ByteView records;
};
struct MessageIndex {
  std::uint16_t channel_id = 0;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> entries;  ///< log time, offset in the uncompressed chunk
};
struct ChunkIndex {
  std::uint64_t start_time = 0;
  std::uint64_t end_time = 0;
  std::uint64_t chunk_offset = 0;  ///< of the Chunk record in the file
  std::uint64_t chunk_length = 0;  ///< of the whole record
  std::map<std::uint16_t, std::uint64_t> message_index_offsets;
  std::uint64_t message_index_length = 0;
  std::string compression;
  std::uint64_t compressed_size = 0;
  std::uint64_t uncompressed_size = 0;
};
struct Attachment {
  std::uint64_t log_time = 0;
  std::uint64_t create_time = 0;
  std::string name;
  std::string media_type;
  std::string data;
};
struct AttachmentIndex {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::uint64_t log_time = 0;
  std::uint64_t create_time = 0;
  std::uint64_t data_size = 0;
  std::string name;
  std::string media_type;
};
struct Metadata {
  std::string name;
  std::map<std::string, std::string> entries;
};
struct MetadataIndex {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::string name;
};
struct Statistics {
  std::uint64_t message_count = 0;
  std::uint16_t schema_count = 0;
  std::uint32_t channel_count = 0;
  std::uint32_t attachment_count = 0;
  std::uint32_t metadata_count = 0;
  std::uint32_t chunk_count = 0;
  std::uint64_t message_start_time = 0;
  std::uint64_t message_end_time = 0;
  std::map<std::uint16_t, std::uint64_t> channel_message_counts;
};
struct SummaryOffset {
  Opcode group = Opcode::Schema;
  std::uint64_t start = 0;
  std::uint64_t length = 0;
};
struct DataEnd {
  std::uint32_t data_section_crc = 0;  ///< 0: none
};
struct Footer {
  std::uint64_t summary_start = 0;  ///< 0: no summary
  std::uint64_t summary_offset_start = 0;
  std::uint32_t summary_crc = 0;  ///< 0: none
};

/// Appends the whole record (opcode, length, content) to `out`.
void append(Bytes& out, const Header& header);
void append(Bytes& out, const Schema& schema);
void append(Bytes& out, const Channel& channel);
void append(Bytes& out, const Message& message);
void append(Bytes& out, const Chunk& chunk);
void append(Bytes& out, const MessageIndex& index);
void append(Bytes& out, const ChunkIndex& index);
void append(Bytes& out, const Attachment& attachment);
void append(Bytes& out, const AttachmentIndex& index);
void append(Bytes& out, const Statistics& statistics);
void append(Bytes& out, const Metadata& metadata);
void append(Bytes& out, const MetadataIndex& index);
void append(Bytes& out, const SummaryOffset& offset);
void append(Bytes& out, const DataEnd& end);
void append(Bytes& out, const Footer& footer);

/// The record whose content (without opcode and length) is `content`; none if it is not one. Views point into
/// `content`.
template <typename Record>
[[nodiscard]] std::optional<Record> parse(ByteView content);
template <>
std::optional<Header> parse(ByteView content);
template <>
std::optional<Schema> parse(ByteView content);
template <>
std::optional<Channel> parse(ByteView content);
template <>
std::optional<Message> parse(ByteView content);
template <>
std::optional<Chunk> parse(ByteView content);
template <>
std::optional<MessageIndex> parse(ByteView content);
template <>
std::optional<ChunkIndex> parse(ByteView content);
template <>
std::optional<Attachment> parse(ByteView content);
template <>
std::optional<AttachmentIndex> parse(ByteView content);
template <>
std::optional<Statistics> parse(ByteView content);
template <>
std::optional<Metadata> parse(ByteView content);
template <>
std::optional<MetadataIndex> parse(ByteView content);
template <>
std::optional<DataEnd> parse(ByteView content);
template <>
std::optional<Footer> parse(ByteView content);

/// The CRC-32 of MCAP (as in zlib) of `bytes`, continued from `before`.
[[nodiscard]] std::uint32_t crc32_of(ByteView bytes, std::uint32_t before = 0);

}  // namespace tandem::mcap
