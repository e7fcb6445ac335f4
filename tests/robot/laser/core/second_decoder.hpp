#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The lasers' scans read a second time, from tables, to be compared with what the driver reads. Shares no code with
/// it.
namespace tandem::second {

/// What a scan says, as plain numbers in the order of the wire.
using Numbers = std::vector<std::int64_t>;

// --- SCIP: a row for each command.
struct ScipRow {
  std::string_view command;
  std::size_t digits;      ///< of the parameters
  std::size_t characters;  ///< of a value
  std::size_t values;      ///< of a step
  std::string_view status;
};
inline constexpr std::array<ScipRow, 6> kScipRows{{{"MD", 13, 3, 1, "99"},
                                                   {"MS", 13, 2, 1, "99"},
                                                   {"ME", 13, 3, 2, "99"},
                                                   {"GD", 10, 3, 1, "00"},
                                                   {"GS", 10, 2, 1, "00"},
                                                   {"GE", 10, 3, 2, "00"}}};

inline std::optional<std::int64_t> digits_at(std::string_view text, std::size_t at, std::size_t count) {
  std::int64_t number = 0;
  for (std::size_t i = at; i < at + count; ++i) {
    if (i >= text.size() || text[i] < '0' || text[i] > '9') return std::nullopt;
    number = 10 * number + (text[i] - '0');
  }
  return number;
}

inline std::optional<std::int64_t> six_bits(std::string_view text, std::size_t at, std::size_t count) {
  std::int64_t number = 0;
  for (std::size_t i = at; i < at + count; ++i) {
    const int digit = text[i] - '0';
    if (digit < 0 || digit > 63) return std::nullopt;
    number = number * 64 + digit;
  }
  return number;
}

inline bool closes_well(std::string_view line) {
  unsigned sum = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) sum += static_cast<unsigned char>(line[i]);
  return !line.empty() && line.back() == static_cast<char>('0' + sum % 64);
}

/// Timestamp, then ranges and strengths by turns; none if `reply`, one whole reply, carries no scan.
inline std::optional<Numbers> scip_scan(std::string_view reply) {
  while (reply.starts_with('\n')) reply.remove_prefix(1);  // the end of one that was cut off
  std::vector<std::string_view> lines;
  for (std::size_t at = 0; at < reply.size();) {
    const std::size_t end = reply.find('\n', at);
    if (end == std::string_view::npos) return std::nullopt;
    lines.push_back(reply.substr(at, end - at));
    at = end + 1;
    if (lines.back().empty() && at != reply.size()) return std::nullopt;  // more than one reply, or none
  }
  if (lines.size() < 5 || !lines.back().empty()) return std::nullopt;
  lines.pop_back();
  const std::string_view echo = lines[0].substr(0, lines[0].find(';'));
  for (const ScipRow& row : kScipRows) {
    if (echo.substr(0, 2) != row.command) continue;
    if (echo.size() != 2 + row.digits || lines[1].size() != 3 || lines[1].substr(0, 2) != row.status) break;
    for (std::size_t i = 1; i < lines.size(); ++i) {
      if (!closes_well(lines[i])) return std::nullopt;
    }
    if (!digits_at(echo, 2, row.digits) || lines[2].size() != 5) break;
    const std::int64_t first = *digits_at(echo, 2, 4);
    const std::int64_t last = *digits_at(echo, 6, 4);
    const std::int64_t cluster = *digits_at(echo, 10, 2);
    const auto timestamp = six_bits(lines[2], 0, 4);
    if (last < first || !timestamp) break;
    std::string data;
    for (std::size_t i = 3; i < lines.size(); ++i) data += lines[i].substr(0, lines[i].size() - 1);
    const auto steps = static_cast<std::size_t>((last - first) / (cluster == 0 ? 1 : cluster) + 1);
    if (data.size() != steps * row.values * row.characters) break;
    Numbers numbers{*timestamp};
    for (std::size_t at = 0; at < data.size(); at += row.characters) {
      const auto value = six_bits(data, at, row.characters);
      if (!value) return std::nullopt;
      numbers.push_back(*value);
    }
    return numbers;
  }
  return std::nullopt;
}

// --- LMS 2xx: the bytes of a scan's telegram by their place.
enum class LmsPlace { Start, Address, Length, Command, Header, Values, Status, Crc };
struct LmsRow {
  LmsPlace place;
  std::size_t bytes;      ///< of one number
  std::int64_t expected;  ///< -1: anything
};
inline constexpr std::array<LmsRow, 8> kLmsRows{{{LmsPlace::Start, 1, 0x02},
                                                 {LmsPlace::Address, 1, 0x80},
                                                 {LmsPlace::Length, 2, -1},
                                                 {LmsPlace::Command, 1, 0xB0},
                                                 {LmsPlace::Header, 2, -1},
                                                 {LmsPlace::Values, 2, -1},
                                                 {LmsPlace::Status, 1, -1},
                                                 {LmsPlace::Crc, 2, -1}}};

/// Bit by bit, from the highest: the register is a remainder.
inline std::int64_t lms_crc(const std::vector<std::uint8_t>& bytes, std::size_t count) {
  std::uint32_t remainder = 0;
  for (std::size_t i = 0; i < count; ++i) {
    remainder *= 2;
    if (remainder >= 0x10000) remainder = (remainder - 0x10000) ^ 0x8005U;
    remainder ^= bytes[i] + 256U * (i > 0 ? bytes[i - 1] : 0U);
  }
  return remainder;
}

/// Unit (1: mm), status, then the values; none if `bytes`, one whole telegram, carries no whole scan.
inline std::optional<Numbers> lms_scan(const std::vector<std::uint8_t>& bytes) {
  std::size_t at = 0;
  std::int64_t length = 0;
  std::int64_t header = 0;
  std::int64_t status = 0;
  Numbers values;
  const auto number = [&](std::size_t count) -> std::optional<std::int64_t> {
    if (at + count > bytes.size()) return std::nullopt;
    const std::int64_t value = bytes[at] + (count == 2 ? 256 * bytes[at + 1] : 0);
    at += count;
    return value;
  };
  for (const LmsRow& row : kLmsRows) {
    if (row.place == LmsPlace::Values) {
      for (std::int64_t i = 0; i < header % 1024; ++i) {
        const auto value = number(row.bytes);
        if (!value) return std::nullopt;
        values.push_back(*value);
      }
      continue;
    }
    if (row.place == LmsPlace::Status) {
      const std::int64_t indices = length - static_cast<std::int64_t>(at - 4) - 1;  // none, one or two bytes
      if (indices < 0 || indices > 2) return std::nullopt;
      at += static_cast<std::size_t>(indices);
    }
    const std::size_t from = at;
    const auto value = number(row.bytes);
    if (!value || (row.expected >= 0 && *value != row.expected)) return std::nullopt;
    if (row.place == LmsPlace::Length) length = *value;
    if (row.place == LmsPlace::Header) header = *value;
    if (row.place == LmsPlace::Status) status = *value;
    if (row.place == LmsPlace::Crc && *value != lms_crc(bytes, from)) return std::nullopt;
  }
  const std::int64_t unit = header / 16'384;
  if (at != bytes.size() || header / 8192 % 2 == 1 || unit > 1 || values.empty()) return std::nullopt;
  Numbers numbers{unit, status};
  numbers.insert(numbers.end(), values.begin(), values.end());
  return numbers;
}

// --- CoLa A: the words of a scan, a letter for each. '.': anything; 'n': a number that is kept.
inline constexpr std::string_view kColaHead = "....ynnnn.....n.";
inline constexpr std::string_view kColaChannel = ".ffss";

inline std::optional<std::int64_t> cola_number(std::string_view word) {
  if (word.empty() || word.size() > 20) return std::nullopt;
  const bool decimal = word[0] == '+' || word[0] == '-';
  const bool negative = word[0] == '-';
  if (decimal) word.remove_prefix(1);
  std::uint64_t value = 0;
  if (word.empty()) return std::nullopt;
  for (const char c : word) {
    int digit = 99;
    if (c >= '0' && c <= '9') digit = c - '0';
    if (!decimal && c >= 'A' && c <= 'F') digit = c - 'A' + 10;
    if (!decimal && c >= 'a' && c <= 'f') digit = c - 'a' + 10;
    if (digit == 99) return std::nullopt;
    value = value * (decimal ? 10U : 16U) + static_cast<unsigned>(digit);
    if (value > 0xFFFFFFFFULL) return std::nullopt;
  }
  if (negative && value > 0x80000000ULL) return std::nullopt;
  return negative ? -static_cast<std::int64_t>(value) : static_cast<std::int64_t>(value);
}

/// Status, counters, clocks, rate, then for each channel start, step, count and values; none if there is no whole scan.
inline std::optional<Numbers> cola_scan(std::string_view text) {
  std::size_t at = 0;
  bool good = true;
  Numbers numbers;
  const auto word = [&]() -> std::string_view {
    if (at > text.size()) good = false;
    if (!good) return {};
    const std::size_t end = text.find(' ', at) == std::string_view::npos ? text.size() : text.find(' ', at);
    const std::string_view found = text.substr(at, end - at);
    at = end + 1;
    return found;
  };
  const auto number = [&](std::int64_t least, std::int64_t most) -> std::int64_t {
    const auto value = cola_number(word());
    if (!value || *value < least || *value > most) good = false;
    return value.value_or(0);
  };
  const auto fields = [&](std::string_view letters) {
    for (const char letter : letters) {
      if (letter == '.') (void)word();
      if (letter == 'y') numbers.push_back(number(0, 0xFF));
      if (letter == 'n') numbers.push_back(number(0, 0xFFFFFFFFLL));
      if (letter == 'f' && number(0, 0xFFFFFFFFLL) / 0x800000 % 256 == 255) good = false;  // not finite
      if (letter == 's') {
        const std::string_view angle = word();
        const auto value = cola_number(angle);
        if (!value || (angle[0] == '+' && *value > 0x7FFFFFFF)) good = false;
        const std::int64_t bits = value.value_or(0);
        numbers.push_back(bits > 0x7FFFFFFF ? bits - 0x100000000LL : bits);
      }
    }
  };
  const std::string_view kind = word();
  if ((kind != "sSN" && kind != "sRA") || word() != "LMDscandata") return std::nullopt;
  fields(kColaHead);
  for (std::int64_t encoders = 2 * number(0, 8); encoders > 0 && good; --encoders) (void)word();
  for (const std::int64_t most : {0xFFFF, 0xFF}) {
    for (std::int64_t channels = number(0, 16); channels > 0 && good; --channels) {
      fields(kColaChannel);
      const std::int64_t count = number(0, 10'000);
      numbers.push_back(count);
      for (std::int64_t i = 0; i < count && good; ++i) numbers.push_back(number(0, most));
    }
  }
  if (!good) return std::nullopt;
  return numbers;
}

}  // namespace tandem::second
