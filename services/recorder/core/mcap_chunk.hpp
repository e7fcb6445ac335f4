#pragma once

#include <string>
#include <variant>

#include "services/recorder/core/mcap_records.hpp"

namespace tandem::mcap {

/// Why a chunk cannot be read.
struct ChunkDamage {
  std::string what;
};

/// The records inside the chunk whose record content is `content`, decompressed and checked against their checksum.
[[nodiscard]] std::variant<Bytes, ChunkDamage> records_in_chunk(ByteView content);

}  // namespace tandem::mcap
