#include "services/recorder/core/mcap_chunk.hpp"

#include <gtest/gtest.h>

namespace tandem::mcap {
namespace {

const Bytes kRecords{'a', 'b', 'c'};

/// The content of a Chunk record.
Bytes content_of(const Chunk& chunk) {
  Bytes record;
  append(record, chunk);
  return {record.begin() + kRecordHead, record.end()};
}

Chunk uncompressed() {
  Chunk chunk;
  chunk.uncompressed_size = kRecords.size();
  chunk.uncompressed_crc = crc32_of(kRecords);
  chunk.records = kRecords;
  return chunk;
}

std::string damage_of(const Chunk& chunk) {
  const auto records = records_in_chunk(content_of(chunk));
  const auto* damage = std::get_if<ChunkDamage>(&records);
  return damage == nullptr ? "" : damage->what;
}

TEST(McapChunk, GivesItsRecords) {
  EXPECT_EQ(std::get<Bytes>(records_in_chunk(content_of(uncompressed()))), kRecords);
}

TEST(McapChunk, AWrongChecksumIsDamage) {
  Chunk chunk = uncompressed();
  ++chunk.uncompressed_crc;
  EXPECT_EQ(damage_of(chunk), "the checksum of a chunk is wrong");
}

TEST(McapChunk, WhatIsNotCompressedAsItSaysIsDamage) {
  for (const char* name : {"zstd", "lz4"}) {
    Chunk chunk = uncompressed();
    chunk.compression = name;
    EXPECT_EQ(damage_of(chunk), "a chunk cannot be decompressed") << name;
  }
}

TEST(McapChunk, AnUnknownCompressionIsNamed) {
  Chunk chunk = uncompressed();
  chunk.compression = "brotli";
  EXPECT_EQ(damage_of(chunk), "a chunk is compressed with \"brotli\", only zstd and lz4 are known");
}

TEST(McapChunk, AnAbsurdSizeIsDamageAndNotMemory) {
  Chunk chunk = uncompressed();
  chunk.uncompressed_size = std::uint64_t{1} << 60;
  EXPECT_EQ(damage_of(chunk), "a chunk is damaged");
}

}  // namespace
}  // namespace tandem::mcap
