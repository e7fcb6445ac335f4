#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>

#include "robot/pioneer/core/packet.hpp"

namespace tandem::pioneer {

/// Appends little-endian fields and NUL-terminated texts to a packet body.
class FieldWriter {
 public:
  explicit FieldWriter(Bytes& bytes) : bytes_(bytes) {}

  template <std::integral Integer>
  void operator()(Integer value) {
    auto rest = static_cast<std::uint64_t>(static_cast<std::make_unsigned_t<Integer>>(value));
    for (std::size_t i = 0; i < sizeof(Integer); ++i, rest >>= 8u) bytes_.push_back(static_cast<std::uint8_t>(rest));
  }
  void operator()(const std::string& text) {
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    bytes_.push_back(0);
  }
  /// Writes an optional field; after the first absent one nothing more is written.
  template <typename Integer>
  void operator()(const std::optional<Integer>& value) {
    ended_ = ended_ || !value;
    if (!ended_) (*this)(*value);
  }

 private:
  Bytes& bytes_;
  bool ended_ = false;
};

/// Reads the same; a field behind the end keeps its value, and ended() says so.
class FieldReader {
 public:
  explicit FieldReader(const Bytes& bytes) : bytes_(bytes) {}

  template <std::integral Integer>
  void operator()(Integer& value) {
    if (left() < sizeof(Integer)) {
      end();
      return;
    }
    std::uint64_t whole = 0;
    for (std::size_t i = 0; i < sizeof(Integer); ++i) whole |= std::uint64_t{bytes_[at_ + i]} << (8u * i);
    at_ += sizeof(Integer);
    value = static_cast<Integer>(whole);
  }
  void operator()(std::string& text) {
    if (left() == 0) {
      end();
      return;
    }
    const auto begin = bytes_.begin() + static_cast<std::ptrdiff_t>(at_);
    const auto terminator = std::find(begin, bytes_.end(), 0);
    text.assign(begin, terminator);
    at_ = static_cast<std::size_t>(terminator - bytes_.begin()) + 1;
  }
  template <typename Integer>
  void operator()(std::optional<Integer>& value) {
    Integer read{};
    (*this)(read);
    if (!ended_) value = read;
  }
  [[nodiscard]] bool ended() const { return ended_; }

 private:
  [[nodiscard]] std::size_t left() const { return at_ < bytes_.size() ? bytes_.size() - at_ : 0; }
  void end() {
    at_ = bytes_.size();
    ended_ = true;
  }

  const Bytes& bytes_;
  std::size_t at_ = 0;
  bool ended_ = false;
};

}  // namespace tandem::pioneer
