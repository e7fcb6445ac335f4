#include "services/recorder/core/mcap_chunk.hpp"

#include "services/recorder/core/mcap_compression.hpp"

namespace tandem::mcap {
namespace {

constexpr std::uint64_t kLargestChunk = 256 << 20;  ///< [bytes] a larger one is taken for damage

}  // namespace

std::variant<Bytes, ChunkDamage> records_in_chunk(ByteView content) {
  const auto chunk = parse<Chunk>(content);
  if (!chunk || chunk->uncompressed_size > kLargestChunk) return ChunkDamage{"a chunk is damaged"};
  const auto compression = compression_named(chunk->compression);
  if (!compression) {
    return ChunkDamage{"a chunk is compressed with \"" + chunk->compression + "\", only zstd and lz4 are known"};
  }
  auto records = decompressed(chunk->records, *compression, chunk->uncompressed_size);
  if (!records) return ChunkDamage{"a chunk cannot be decompressed"};
  if (chunk->uncompressed_crc != 0 && crc32_of(*records) != chunk->uncompressed_crc) {
    return ChunkDamage{"the checksum of a chunk is wrong"};
  }
  return *std::move(records);
}

}  // namespace tandem::mcap
