#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// SICK's Command Language in its text form, CoLa A (LMS 1xx, LMS 5xx, TiM): words between STX and ETX.
///
/// A word is a hexadecimal number, or a decimal one with its sign, or text. Source: the published telegram listings and
/// the protocol's open drivers.
namespace tandem::cola {

/// The words of one telegram; the first is its kind: sRN, sRA, sWN, sWA, sMN, sAN, sEN, sEA, sSN, sFA.
using Words = std::vector<std::string>;

/// The bytes of a telegram with this text.
[[nodiscard]] std::string bytes_of(std::string_view text);
/// `text` cut at each space.
[[nodiscard]] Words words_of(std::string_view text);

/// The number that a word is, hexadecimal or signed decimal; none if it is none, or not one of 32 bits.
[[nodiscard]] std::optional<std::int64_t> parse_number(std::string_view word);
/// A hexadecimal word taken as signed 32 bits, as angles are; a decimal one with its sign.
[[nodiscard]] std::optional<std::int32_t> parse_signed(std::string_view word);
/// A hexadecimal word taken for the bits of a float; none unless it is finite.
[[nodiscard]] std::optional<float> parse_float(std::string_view word);
[[nodiscard]] std::string hexadecimal(std::uint32_t number);
[[nodiscard]] std::string hexadecimal_float(float number);

/// Puts the texts of telegrams together from bytes, however they are split in reading.
///
/// An STX begins a telegram whatever stands before it, and what is longer than any telegram is dropped.
class TelegramReader {
 public:
  static constexpr std::size_t kMostCharacters = 65'536;

  [[nodiscard]] std::vector<std::string> take(std::span<const std::uint8_t> bytes);
  /// Telegrams that had no end, and bytes in them that are no text.
  [[nodiscard]] std::uint64_t damaged() const { return damaged_; }
  /// True once the start of a binary telegram, CoLa B, was seen: four STX in a row.
  [[nodiscard]] bool saw_binary() const { return saw_binary_; }

 private:
  void drop();

  bool inside_ = false;
  std::string text_;
  int starts_in_a_row_ = 0;
  bool saw_binary_ = false;
  std::uint64_t damaged_ = 0;
};

}  // namespace tandem::cola
