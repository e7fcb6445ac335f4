#pragma once

#include <filesystem>
#include <memory>

#include "services/recorder/core/mcap_records.hpp"

namespace tandem::mcap {

/// Bytes that can be read at any place: a file, or memory in tests.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  [[nodiscard]] virtual std::uint64_t size() const = 0;
  /// `length` bytes from `offset`, fewer at the end. Throws McapError when they cannot be read.
  [[nodiscard]] virtual Bytes read(std::uint64_t offset, std::uint64_t length) = 0;
};

/// The bytes of `file`. Throws McapError when it cannot be opened.
[[nodiscard]] std::unique_ptr<ByteSource> file_source(const std::filesystem::path& file);
[[nodiscard]] std::unique_ptr<ByteSource> memory_source(Bytes bytes);

}  // namespace tandem::mcap
