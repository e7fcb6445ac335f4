#include "services/recorder/core/mcap_chunk.hpp"

#include <zstd.h>

namespace tandem::mcap {
namespace {

constexpr std::uint64_t kLargestChunk = 256 << 20;  ///< [bytes] a larger one is taken for damage

}  // namespace

std::variant<Bytes, ChunkDamage> records_in_chunk(ByteView content) {
  const auto chunk = parse<Chunk>(content);
  if (!chunk || chunk->uncompressed_size > kLargestChunk) return ChunkDamage{"a chunk is damaged"};
  Bytes records;
  if (chunk->compression.empty()) {
    records.assign(chunk->records.begin(), chunk->records.end());
  } else if (chunk->compression == "zstd") {
    records.resize(static_cast<std::size_t>(chunk->uncompressed_size));
    const std::size_t size =
        ZSTD_decompress(records.data(), records.size(), chunk->records.data(), chunk->records.size());
    if (ZSTD_isError(size) || size != records.size()) return ChunkDamage{"a chunk cannot be decompressed"};
  } else {
    return ChunkDamage{"a chunk is compressed with \"" + chunk->compression + "\", only zstd is known"};
  }
  if (chunk->uncompressed_crc != 0 && crc32_of(records) != chunk->uncompressed_crc) {
    return ChunkDamage{"the checksum of a chunk is wrong"};
  }
  return records;
}

}  // namespace tandem::mcap
