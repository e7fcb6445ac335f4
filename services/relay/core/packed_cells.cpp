#include "services/relay/core/packed_cells.hpp"

#include <zstd.h>

namespace tandem {
namespace {

constexpr int kLevel = 9;                        // a map is packed once
constexpr std::size_t kMostCells = 400'000'000;  // 1 km x 1 km in cells of 5 cm

}  // namespace

std::vector<std::uint8_t> packed_cells(const std::vector<std::uint8_t>& cells) {
  std::vector<std::uint8_t> packed(ZSTD_compressBound(cells.size()));
  const std::size_t size = ZSTD_compress(packed.data(), packed.size(), cells.data(), cells.size(), kLevel);
  packed.resize(ZSTD_isError(size) ? 0 : size);
  return packed;
}

std::optional<std::vector<std::uint8_t>> unpacked_cells(const std::vector<std::uint8_t>& packed, std::size_t count) {
  if (count > kMostCells || ZSTD_getFrameContentSize(packed.data(), packed.size()) != count) return std::nullopt;
  std::vector<std::uint8_t> cells(count);
  if (ZSTD_decompress(cells.data(), cells.size(), packed.data(), packed.size()) != count) return std::nullopt;
  return cells;
}

}  // namespace tandem
