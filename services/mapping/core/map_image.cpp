#include "services/mapping/core/map_image.hpp"

#include <cctype>
#include <stdexcept>

namespace tandem {
namespace {

constexpr std::int64_t kMaxSide = 1'000'000;  ///< pixels; keeps every product within 64 bits

/// Reads the whitespace- and comment-separated numbers of a PGM header.
class PgmHeader {
 public:
  explicit PgmHeader(const std::string& bytes) : bytes_(bytes) {}

  std::int64_t number(const char* what) {
    skip_space_and_comments();
    std::int64_t value = 0;
    const std::size_t begin = at_;
    while (at_ < bytes_.size() && std::isdigit(static_cast<unsigned char>(bytes_[at_])) != 0) {
      value = value * 10 + (bytes_[at_++] - '0');
      if (value > kMaxSide) throw std::runtime_error{std::string{what} + " in the header is absurd"};
    }
    if (at_ == begin) throw std::runtime_error{std::string{what} + " is missing in the header"};
    return value;
  }
  [[nodiscard]] std::size_t position() const { return at_; }

 private:
  void skip_space_and_comments() {
    while (at_ < bytes_.size()) {
      if (bytes_[at_] == '#') {
        while (at_ < bytes_.size() && bytes_[at_] != '\n') ++at_;
      } else if (std::isspace(static_cast<unsigned char>(bytes_[at_])) != 0) {
        ++at_;
      } else {
        return;
      }
    }
  }
  const std::string& bytes_;
  std::size_t at_ = 2;  // after the magic number
};

ImageSize pgm_size(const std::string& bytes) {
  PgmHeader header{bytes};
  const ImageSize size{header.number("width"), header.number("height")};
  const std::int64_t brightest = header.number("the maximum value");
  if (brightest < 1 || brightest > 65535) throw std::runtime_error{"the maximum value is not in 1..65535"};
  const std::int64_t bytes_per_pixel = bytes[1] == '5' && brightest > 255 ? 2 : 1;  // text: at least one digit
  const auto rest = static_cast<std::int64_t>(bytes.size() - header.position());
  if (rest < size.width * size.height * bytes_per_pixel) {
    throw std::runtime_error{"the file ends early: " + std::to_string(size.width) + " x " +
                             std::to_string(size.height) + " pixels do not fit in " + std::to_string(bytes.size()) +
                             " bytes"};
  }
  return size;
}

std::int64_t big_endian(const std::string& bytes, std::size_t at) {
  std::int64_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value * 256 + static_cast<unsigned char>(bytes[at + i]);
  return value;
}

}  // namespace

ImageSize image_size(const std::string& bytes) {
  ImageSize size;
  if (bytes.starts_with("P5") || bytes.starts_with("P2")) {
    size = pgm_size(bytes);
  } else if (bytes.starts_with("\x89PNG\r\n\x1a\n") && bytes.size() >= 33) {
    size = {big_endian(bytes, 16), big_endian(bytes, 20)};
  } else {
    throw std::runtime_error{"neither a PGM nor a PNG image"};
  }
  if (size.width < 1 || size.height < 1) throw std::runtime_error{"the image has no pixels"};
  if (size.width > kMaxSide || size.height > kMaxSide) throw std::runtime_error{"the size in the header is absurd"};
  return size;
}

}  // namespace tandem
