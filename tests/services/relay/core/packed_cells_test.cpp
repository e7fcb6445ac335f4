#include "services/relay/core/packed_cells.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

TEST(PackedCells, ComeBackAsTheyWere) {
  std::vector<std::uint8_t> cells(1000, 0);
  cells[7] = 100;
  cells[999] = 255;
  const auto packed = packed_cells(cells);
  EXPECT_LT(packed.size(), 100U);
  EXPECT_EQ(unpacked_cells(packed, 1000), cells);
}

TEST(PackedCells, AreNoneIfTheyAreOfAnotherCount) {
  const auto packed = packed_cells(std::vector<std::uint8_t>(1000, 0));
  EXPECT_FALSE(unpacked_cells(packed, 999).has_value());
  EXPECT_FALSE(unpacked_cells(packed, 1001).has_value());
  EXPECT_FALSE(unpacked_cells(packed, 1'000'000'000'000).has_value());
}

TEST(PackedCells, AreNoneOfGarbage) {
  auto packed = packed_cells(std::vector<std::uint8_t>(1000, 0));
  packed.back() ^= 0xFF;
  packed[packed.size() / 2] ^= 0xFF;
  const auto cells = unpacked_cells(packed, 1000);
  EXPECT_TRUE(!cells || cells->size() == 1000);  // zstd without checksum: sizes hold, the map's hash does the rest
  EXPECT_FALSE(unpacked_cells({}, 1000).has_value());
  EXPECT_FALSE(unpacked_cells({1, 2, 3, 4, 5}, 5).has_value());
}

}  // namespace
}  // namespace tandem
