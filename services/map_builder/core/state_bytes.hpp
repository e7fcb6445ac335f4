#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace tandem {

template <typename T>
concept PlainNumber = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Numbers to bytes, as this machine holds them. It has the functions of NumberReader, so that one list of fields
/// serves both.
class NumberWriter {
 public:
  template <PlainNumber T>
  void number(const T& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  /// How many elements a vector has.
  template <typename T>
  void size(const std::vector<T>& values) {
    number(static_cast<std::uint64_t>(values.size()));
  }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Bytes of a NumberWriter back to numbers; once they do not suffice all that follows is zero, or empty.
class NumberReader {
 public:
  explicit NumberReader(std::string_view bytes) : bytes_(bytes) {}

  template <PlainNumber T>
  void number(T& value) {
    value = {};
    if (bytes_.size() < sizeof value) {
      is_short_ = true;
      bytes_ = {};
      return;
    }
    std::memcpy(&value, bytes_.data(), sizeof value);
    bytes_.remove_prefix(sizeof value);
  }
  /// Gives a vector the size that was written; its elements follow.
  template <typename T>
  void size(std::vector<T>& values) {
    values.resize(count());
  }
  /// The size alone.
  [[nodiscard]] std::size_t count() {
    std::uint64_t size = 0;
    number(size);
    if (size > bytes_.size()) {  // each element takes a byte at least
      is_short_ = true;
      return 0;
    }
    return static_cast<std::size_t>(size);
  }
  /// Were there just as many bytes as were asked for?
  [[nodiscard]] bool is_whole() const { return !is_short_ && bytes_.empty(); }

 private:
  std::string_view bytes_;
  bool is_short_ = false;
};

}  // namespace tandem
