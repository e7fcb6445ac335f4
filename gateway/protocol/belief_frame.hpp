#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tandem::protocol {

/// The belief grid as the one binary frame of the protocol, little-endian:
/// `u8 type = 1, u8 version = 1, u16 width, u16 height, f32 resolution, x0, y0 [m], u32 revision, u8 cells...`.
struct BeliefGrid {
  std::uint16_t width = 0;
  std::uint16_t height = 0;
  float resolution_m = 0.0F;
  float x0_m = 0.0F;  ///< corner of cell (0, 0)
  float y0_m = 0.0F;
  std::uint32_t revision = 0;
  std::vector<std::uint8_t> cells;  ///< 0 to 254: share of the peak; 255: not searched
};

[[nodiscard]] std::string write(const BeliefGrid& grid);

}  // namespace tandem::protocol
