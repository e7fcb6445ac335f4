#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace tandem::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// What must hold for every input; ends the program where it does not.
inline void check(bool holds) {
  if (!holds) __builtin_trap();
}

inline Bytes bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Gives `bytes` to `take` in pieces, one input in four byte by byte, the others with lengths that the bytes say.
template <typename Take>
void in_pieces(Bytes bytes, Take&& take) {
  const bool singly = !bytes.empty() && bytes.back() % 4 == 0;
  while (!bytes.empty()) {
    const std::size_t length = singly ? 1 : 1 + bytes[0] % 16;
    const std::size_t piece = length < bytes.size() ? length : bytes.size();
    take(bytes.first(piece));
    bytes = bytes.subspan(piece);
  }
}

/// What a reader like `fresh` takes from `input`; in pieces it must take as much.
template <typename Reader>
auto taken_whole_and_in_pieces(Bytes input, const Reader& fresh) {
  Reader whole = fresh;
  Reader pieces = fresh;
  auto taken = whole.take(input);
  std::size_t count = 0;
  in_pieces(input, [&](Bytes piece) { count += pieces.take(piece).size(); });
  check(count == taken.size() && whole.damaged() == pieces.damaged());
  return taken;
}

/// True for one input in 32: what costs much is asked for them alone.
inline bool is_chosen(Bytes bytes) {
  return !bytes.empty() && bytes.back() % 32 == 0;
}

}  // namespace tandem::fuzz
