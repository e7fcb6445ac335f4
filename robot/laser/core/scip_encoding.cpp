#include "robot/laser/core/scip_encoding.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>

namespace tandem::scip {
namespace {

constexpr unsigned kBitsPerCharacter = 6;
constexpr std::uint32_t kMask = 0x3F;
constexpr char kZero = '0';  // 0x30

}  // namespace

char checksum(std::string_view text) {
  std::uint32_t sum = 0;
  for (const char c : text) sum += static_cast<unsigned char>(c);
  return static_cast<char>(kZero + static_cast<char>(sum & kMask));
}

std::string encode_number(std::uint32_t value, std::size_t characters) {
  std::string text(characters, kZero);
  for (auto c = text.rbegin(); c != text.rend(); ++c) {
    *c = static_cast<char>(kZero + static_cast<char>(value & kMask));
    value >>= kBitsPerCharacter;
  }
  return text;
}

std::optional<std::uint32_t> decode_number(std::string_view characters) {
  if (characters.empty() || characters.size() > 5) return std::nullopt;
  std::uint32_t value = 0;
  for (const char c : characters) {
    if (c < kZero || c > kZero + static_cast<char>(kMask)) return std::nullopt;
    value = (value << kBitsPerCharacter) | static_cast<std::uint32_t>(c - kZero);
  }
  return value;
}

std::string decimal(int value, std::size_t digits) {
  assert(value >= 0);
  const std::string text = std::to_string(value);
  assert(text.size() <= digits);
  return std::string(digits - text.size(), '0') + text;
}

std::optional<int> parse_decimal(std::string_view digits) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (digits.empty() || !std::all_of(digits.begin(), digits.end(), is_digit)) return std::nullopt;
  int value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{}) return std::nullopt;
  return value;
}

}  // namespace tandem::scip
