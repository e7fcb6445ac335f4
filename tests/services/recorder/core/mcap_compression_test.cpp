#include "services/recorder/core/mcap_compression.hpp"

#include <gtest/gtest.h>

namespace tandem::mcap {
namespace {

constexpr Compression kAll[] = {Compression::None, Compression::Zstd, Compression::Lz4};

TEST(McapCompression, WhatWasPackedComesBack) {
  for (const std::size_t size : {0, 1, 1000, 1 << 20}) {
    Bytes bytes(size);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i / 7);
    for (const Compression compression : kAll) {
      EXPECT_EQ(decompressed(compressed(bytes, compression), compression, size), bytes) << name_of(compression);
    }
  }
}

TEST(McapCompression, Lz4IsTheFrameFormatOfTheSpecification) {
  const Bytes packed = compressed(Bytes(100, 7), Compression::Lz4);
  EXPECT_EQ((Bytes{packed.begin(), packed.begin() + 4}), (Bytes{0x04, 0x22, 0x4D, 0x18}));  // its magic number
}

TEST(McapCompression, AnotherSizeThanPromisedIsNone) {
  for (const Compression compression : kAll) {
    const Bytes packed = compressed(Bytes(100, 7), compression);
    EXPECT_FALSE(decompressed(packed, compression, 99)) << name_of(compression);
    EXPECT_FALSE(decompressed(packed, compression, 101)) << name_of(compression);
  }
}

TEST(McapCompression, WhatIsCutShortIsNone) {
  for (const Compression compression : kAll) {
    const Bytes packed = compressed(Bytes(1000, 7), compression);
    for (std::size_t length = 0; length < packed.size(); ++length) {
      EXPECT_FALSE(decompressed(ByteView{packed}.first(length), compression, 1000)) << name_of(compression);
    }
  }
}

TEST(McapCompression, IsFoundByItsName) {
  for (const Compression compression : kAll) EXPECT_EQ(compression_named(name_of(compression)), compression);
  EXPECT_FALSE(compression_named("bz2"));
}

}  // namespace
}  // namespace tandem::mcap
