#include "gateway/protocol/belief_frame.hpp"

#include <bit>

namespace tandem::protocol {
namespace {

template <typename Unsigned>
void append(std::string& bytes, Unsigned value) {
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) bytes += static_cast<char>((value >> (8 * i)) & 0xff);
}

void append(std::string& bytes, float value) {
  append(bytes, std::bit_cast<std::uint32_t>(value));
}

}  // namespace

std::string write(const BeliefGrid& grid) {
  std::string bytes;
  bytes.reserve(22 + grid.cells.size());
  bytes += '\x01';
  bytes += '\x01';
  append(bytes, grid.width);
  append(bytes, grid.height);
  append(bytes, grid.resolution_m);
  append(bytes, grid.x0_m);
  append(bytes, grid.y0_m);
  append(bytes, grid.revision);
  bytes.append(grid.cells.begin(), grid.cells.end());
  return bytes;
}

}  // namespace tandem::protocol
