#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tandem {

/// The cells of a map, compressed (zstd): most are equal to their neighbours.
[[nodiscard]] std::vector<std::uint8_t> packed_cells(const std::vector<std::uint8_t>& cells);

/// The inverse; none if `packed` is not exactly `count` cells. Bytes come from outside: no more than `count` is made.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> unpacked_cells(const std::vector<std::uint8_t>& packed,
                                                                      std::size_t count);

}  // namespace tandem
