#pragma once

#include <cstddef>

namespace tandem::bench {

/// How a file of 1 MB fared that was cut, or had bits flipped.
struct DamageResult {
  std::size_t tried = 0;
  std::size_t failed = 0;  ///< times at which something whole was not read
};

/// Cuts an unchunked, a zstd and an lz4 file at every `step`-th byte.
[[nodiscard]] DamageResult cut_everywhere(std::size_t step);

/// Flips up to five random bits in such files, `times` each.
[[nodiscard]] DamageResult flip_bits(std::size_t times);

}  // namespace tandem::bench
