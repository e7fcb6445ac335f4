#include "services/recorder/core/ros1_bag.hpp"

#include <bzlib.h>

#include <map>
#include <optional>
#include <string_view>

#include "services/recorder/core/mcap_compression.hpp"

namespace tandem::ros {
namespace {

using mcap::Bytes;
using mcap::ByteView;

constexpr std::string_view kMagic = "#ROSBAG V2.0\n";
constexpr std::uint32_t kLargestChunk = 512U << 20;  ///< [bytes] a larger one is taken for damage
constexpr std::uint8_t kMessageData = 0x02;
constexpr std::uint8_t kChunk = 0x05;
constexpr std::uint8_t kConnection = 0x07;

std::uint32_t number_at(ByteView bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= static_cast<std::uint32_t>(bytes[at + i]) << (8 * i);
  return value;
}

/// The named fields of a record's header, or of the description of a connection.
using FieldMap = std::map<std::string, ByteView>;

std::optional<FieldMap> fields_of(ByteView header) {
  FieldMap fields;
  while (!header.empty()) {
    if (header.size() < 4) return std::nullopt;
    const std::uint32_t length = number_at(header, 0);
    if (length > header.size() - 4) return std::nullopt;
    const ByteView field = header.subspan(4, length);
    const std::string_view text{reinterpret_cast<const char*>(field.data()), field.size()};
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) return std::nullopt;
    fields[std::string{text.substr(0, equals)}] = field.subspan(equals + 1);
    header = header.subspan(4 + length);
  }
  return fields;
}

std::string text_of(const FieldMap& fields, const std::string& name) {
  const auto field = fields.find(name);
  if (field == fields.end()) return "";
  return {field->second.begin(), field->second.end()};
}

std::optional<std::uint32_t> number_of(const FieldMap& fields, const std::string& name, std::size_t at = 0) {
  const auto field = fields.find(name);
  if (field == fields.end() || field->second.size() < at + 4) return std::nullopt;
  return number_at(field->second, at);
}

std::uint8_t opcode_of(const FieldMap& fields) {
  const auto field = fields.find("op");
  return field == fields.end() || field->second.size() != 1 ? std::uint8_t{0} : field->second[0];
}

struct Record {
  FieldMap fields;
  ByteView data;
  std::size_t size = 0;  ///< of all of it
};

/// The record at the front of `bytes`; none if there is no whole one.
std::optional<Record> record_at(ByteView bytes) {
  if (bytes.size() < 8) return std::nullopt;
  const std::uint32_t header_size = number_at(bytes, 0);
  if (header_size > bytes.size() - 8) return std::nullopt;
  const std::uint32_t data_size = number_at(bytes, 4 + header_size);
  if (data_size > bytes.size() - 8 - header_size) return std::nullopt;
  auto fields = fields_of(bytes.subspan(4, header_size));
  if (!fields) return std::nullopt;
  return Record{*std::move(fields), bytes.subspan(8 + header_size, data_size),
                std::size_t{8} + header_size + data_size};
}

std::optional<Bytes> unpacked(ByteView packed, const std::string& compression, std::uint32_t size) {
  if (size > kLargestChunk) return std::nullopt;
  if (compression == "none") return mcap::decompressed(packed, mcap::Compression::None, size);
  if (compression == "lz4") return mcap::decompressed(packed, mcap::Compression::Lz4, size);
  if (compression != "bz2") return std::nullopt;
  Bytes out(size);
  unsigned int written = size;
  Bytes in{packed.begin(), packed.end()};
  const int result =
      BZ2_bzBuffToBuffDecompress(reinterpret_cast<char*>(out.data()), &written, reinterpret_cast<char*>(in.data()),
                                 static_cast<unsigned int>(in.size()), 0, 0);
  if (result != BZ_OK || written != size) return std::nullopt;
  return out;
}

class BagReader {
 public:
  BagReader(std::string name, const OnBagMessage& on_message) : name_(std::move(name)), on_message_(on_message) {}

  void take(const Record& record, std::uint64_t offset) {
    const std::uint8_t opcode = opcode_of(record.fields);
    if (opcode == kConnection) {
      take_connection(record);
    } else if (opcode == kMessageData) {
      take_message(record);
    } else if (opcode == kChunk) {
      take_chunk(record, offset);
    }
  }

 private:
  struct Connection {
    std::string topic;
    std::string type;
  };

  void take_connection(const Record& record) {
    const auto id = number_of(record.fields, "conn");
    const auto description = fields_of(record.data);
    if (id && description) connections_[*id] = {text_of(record.fields, "topic"), text_of(*description, "type")};
  }

  void take_message(const Record& record) {
    const auto id = number_of(record.fields, "conn");
    const auto seconds = number_of(record.fields, "time");
    const auto nanoseconds = number_of(record.fields, "time", 4);
    const auto connection = id ? connections_.find(*id) : connections_.end();
    if (connection == connections_.end() || !seconds || !nanoseconds) return;
    on_message_({connection->second.topic, connection->second.type,
                 static_cast<std::int64_t>(*seconds) * 1'000'000'000 + *nanoseconds, record.data});
  }

  void take_chunk(const Record& record, std::uint64_t offset) {
    const std::string compression = text_of(record.fields, "compression");
    const auto records = unpacked(record.data, compression, number_of(record.fields, "size").value_or(0));
    if (!records) fail(offset, "a chunk (compression \"" + compression + "\") cannot be unpacked");
    ByteView rest{*records};
    while (!rest.empty()) {
      const auto inner = record_at(rest);
      if (!inner) fail(offset, "a chunk ends inside a record");
      take(*inner, offset);
      rest = rest.subspan(inner->size);
    }
  }

  [[noreturn]] void fail(std::uint64_t offset, const std::string& what) const {
    throw BagError(name_ + ": byte " + std::to_string(offset) + ": " + what);
  }

  std::string name_;
  const OnBagMessage& on_message_;
  std::map<std::uint32_t, Connection> connections_;
};

}  // namespace

void read_ros1_bag(mcap::ByteSource& source, const std::string& name, const OnBagMessage& on_message) {
  const Bytes magic = source.read(0, kMagic.size());
  if (std::string_view{reinterpret_cast<const char*>(magic.data()), magic.size()} != kMagic) {
    throw BagError(name + ": is not a ROS 1 bag of format 2.0");
  }
  BagReader bag{name, on_message};
  std::uint64_t offset = kMagic.size();
  while (source.size() - offset >= 8) {
    // Sizes first: a record is read as a whole, and a file may be larger than the memory.
    const std::uint64_t header_size = number_at(source.read(offset, 4), 0);
    if (header_size > source.size() - offset - 8) return;
    const std::uint64_t data_size = number_at(source.read(offset + 4 + header_size, 4), 0);
    const std::uint64_t size = 8 + header_size + data_size;
    if (size > source.size() - offset) return;  // the recorder was killed here
    const Bytes bytes = source.read(offset, size);
    const auto record = record_at(bytes);
    if (!record) throw BagError(name + ": byte " + std::to_string(offset) + ": a record is damaged");
    bag.take(*record, offset);
    offset += size;
  }
}

}  // namespace tandem::ros
