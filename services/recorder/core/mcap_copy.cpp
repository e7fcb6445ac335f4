#include "services/recorder/core/mcap_copy.hpp"

namespace tandem::mcap {

bool copy(Reader& reader, Writer& writer, std::uint64_t from_time) {
  bool good = true;
  for (const auto& [id, schema] : reader.schemas()) good = good && writer.write(schema);
  for (const auto& [id, channel] : reader.channels()) good = good && writer.write(channel);
  for (const Metadata& metadata : reader.metadata()) good = good && writer.write(metadata);
  for (const Attachment& attachment : reader.attachments()) good = good && writer.write(attachment);
  for (std::size_t i = 0; good && i < reader.message_count(); ++i) {
    if (reader.log_time_at(i) < from_time) continue;
    if (const auto message = reader.message_at(i)) good = writer.write(*message);
  }
  return good;
}

}  // namespace tandem::mcap
