#pragma once

#include <optional>
#include <string>

#include "services/recorder/core/mcap_records.hpp"

namespace tandem::mcap {

/// How the records of a chunk are packed; `lz4` is the LZ4 *frame* format, as the MCAP specification wants it.
enum class Compression { None, Zstd, Lz4 };

/// As it stands in a Chunk record: "", "zstd", "lz4".
[[nodiscard]] std::string name_of(Compression compression);
/// The compression of that name; none for one that we do not know.
[[nodiscard]] std::optional<Compression> compression_named(const std::string& name);

/// `bytes`, packed. Throws McapError when the library refuses, which it does for want of memory only.
[[nodiscard]] Bytes compressed(ByteView bytes, Compression compression);

/// What `packed` held: exactly `size` bytes, else none. Never takes much more memory than `packed` can have come from,
/// whatever a damaged `size` claims.
[[nodiscard]] std::optional<Bytes> decompressed(ByteView packed, Compression compression, std::uint64_t size);

}  // namespace tandem::mcap
