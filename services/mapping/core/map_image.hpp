#pragma once

#include <cstdint>
#include <string>

namespace tandem {

/// Size of an image as its header tells, before anything is decoded.
struct ImageSize {
  std::int64_t width = 0;
  std::int64_t height = 0;
};

/// Reads the header of a PGM (P2, P5) or PNG image in `bytes`. Throws std::runtime_error, saying what is wrong, if it
/// is neither, if a number is absurd, or if a PGM holds fewer bytes than its size needs.
[[nodiscard]] ImageSize image_size(const std::string& bytes);

}  // namespace tandem
