#include "services/recorder/core/mcap_compression.hpp"

#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <memory>

namespace tandem::mcap {
namespace {

constexpr int kZstdLevel = 3;
constexpr std::uint64_t kMostLz4Expands = 256;  ///< a byte of LZ4 stands for at most 255

struct FreeContext {
  void operator()(LZ4F_dctx* context) const { LZ4F_freeDecompressionContext(context); }
};

Bytes zstd_compressed(ByteView bytes) {
  Bytes out(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), kZstdLevel);
  if (ZSTD_isError(size)) throw McapError(std::string{"zstd cannot compress: "} + ZSTD_getErrorName(size));
  out.resize(size);
  return out;
}

Bytes lz4_compressed(ByteView bytes) {
  LZ4F_preferences_t preferences{};
  preferences.frameInfo.contentSize = bytes.size();
  Bytes out(LZ4F_compressFrameBound(bytes.size(), &preferences));
  const std::size_t size = LZ4F_compressFrame(out.data(), out.size(), bytes.data(), bytes.size(), &preferences);
  if (LZ4F_isError(size)) throw McapError(std::string{"lz4 cannot compress: "} + LZ4F_getErrorName(size));
  out.resize(size);
  return out;
}

std::optional<Bytes> zstd_decompressed(ByteView packed, std::uint64_t size) {
  const unsigned long long promised = ZSTD_getFrameContentSize(packed.data(), packed.size());
  if (promised == ZSTD_CONTENTSIZE_ERROR) return std::nullopt;
  if (promised != ZSTD_CONTENTSIZE_UNKNOWN && promised > size) return std::nullopt;
  Bytes out(static_cast<std::size_t>(size));
  const std::size_t written = ZSTD_decompress(out.data(), out.size(), packed.data(), packed.size());
  if (ZSTD_isError(written) || written != out.size()) return std::nullopt;
  return out;
}

std::optional<Bytes> lz4_decompressed(ByteView packed, std::uint64_t size) {
  if (size / kMostLz4Expands > packed.size()) return std::nullopt;
  LZ4F_dctx* made = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION))) return std::nullopt;
  const std::unique_ptr<LZ4F_dctx, FreeContext> context{made};
  Bytes out(static_cast<std::size_t>(size));
  std::size_t read = 0;
  std::size_t written = 0;
  std::size_t wanted = 1;  // 0 once a frame has ended
  while (wanted != 0) {
    std::size_t taken = packed.size() - read;
    std::size_t given = out.size() - written;
    wanted = LZ4F_decompress(context.get(), out.data() + written, &given, packed.data() + read, &taken, nullptr);
    if (LZ4F_isError(wanted) || (taken == 0 && given == 0)) return std::nullopt;
    read += taken;
    written += given;
  }
  if (written != out.size() || read != packed.size()) return std::nullopt;
  return out;
}

}  // namespace

std::string name_of(Compression compression) {
  switch (compression) {
    case Compression::None:
      return "";
    case Compression::Zstd:
      return "zstd";
    case Compression::Lz4:
      return "lz4";
  }
  return "";
}

std::optional<Compression> compression_named(const std::string& name) {
  for (const Compression known : {Compression::None, Compression::Zstd, Compression::Lz4}) {
    if (name == name_of(known)) return known;
  }
  return std::nullopt;
}

Bytes compressed(ByteView bytes, Compression compression) {
  if (compression == Compression::Zstd) return zstd_compressed(bytes);
  if (compression == Compression::Lz4) return lz4_compressed(bytes);
  return {bytes.begin(), bytes.end()};
}

std::optional<Bytes> decompressed(ByteView packed, Compression compression, std::uint64_t size) {
  if (compression == Compression::Zstd) return zstd_decompressed(packed, size);
  if (compression == Compression::Lz4) return lz4_decompressed(packed, size);
  if (packed.size() != size) return std::nullopt;
  return Bytes{packed.begin(), packed.end()};
}

}  // namespace tandem::mcap
