#include "robot/laser/core/cola_telegram.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <utility>

namespace tandem::cola {
namespace {

constexpr std::uint8_t kStart = 0x02;
constexpr std::uint8_t kEnd = 0x03;
constexpr int kStartsOfBinary = 4;

bool is_text(std::uint8_t byte) {
  return byte >= 0x20 && byte < 0x7F;
}

std::optional<std::int64_t> whole_number(std::string_view digits, int base) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

}  // namespace

std::string bytes_of(std::string_view text) {
  std::string bytes(1, static_cast<char>(kStart));
  bytes += text;
  bytes += static_cast<char>(kEnd);
  return bytes;
}

Words words_of(std::string_view text) {
  Words words;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t space = std::min(text.find(' ', from), text.size());
    words.emplace_back(text.substr(from, space - from));
    from = space + 1;
  }
  return words;
}

std::optional<std::int64_t> parse_number(std::string_view word) {
  if (word.empty()) return std::nullopt;
  std::optional<std::int64_t> value;
  if (word[0] == '+') {
    if (word.size() > 1 && word[1] != '-') value = whole_number(word.substr(1), 10);
  } else {
    value = word[0] == '-' ? whole_number(word, 10) : whole_number(word, 16);
  }
  if (!value || *value > UINT32_MAX || *value < INT32_MIN) return std::nullopt;
  return value;
}

std::optional<std::int32_t> parse_signed(std::string_view word) {
  const auto value = parse_number(word);
  if (!value) return std::nullopt;
  const bool decimal = word[0] == '+' || word[0] == '-';
  if (decimal && *value > INT32_MAX) return std::nullopt;
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(*value));
}

std::optional<float> parse_float(std::string_view word) {
  const auto bits = parse_number(word);
  if (!bits || *bits < 0) return std::nullopt;
  const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(*bits));
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

std::string hexadecimal(std::uint32_t number) {
  char digits[8];
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, number, 16);
  std::string text{digits, end};
  for (char& digit : text) {
    if (digit >= 'a') digit = static_cast<char>(digit - 'a' + 'A');
  }
  return text;
}

std::string hexadecimal_float(float number) {
  return hexadecimal(std::bit_cast<std::uint32_t>(number));
}

std::vector<std::string> TelegramReader::take(std::span<const std::uint8_t> bytes) {
  std::vector<std::string> texts;
  for (const std::uint8_t byte : bytes) {
    starts_in_a_row_ = byte == kStart ? starts_in_a_row_ + 1 : 0;
    if (starts_in_a_row_ >= kStartsOfBinary) saw_binary_ = true;
    if (byte == kStart) {
      if (inside_ && !text_.empty()) ++damaged_;
      inside_ = true;
      text_.clear();
    } else if (!inside_) {
      continue;
    } else if (byte == kEnd) {
      texts.push_back(std::exchange(text_, {}));
      inside_ = false;
    } else if (!is_text(byte) || text_.size() >= kMostCharacters) {
      drop();
    } else {
      text_.push_back(static_cast<char>(byte));
    }
  }
  return texts;
}

void TelegramReader::drop() {
  ++damaged_;
  inside_ = false;
  text_.clear();
}

}  // namespace tandem::cola
