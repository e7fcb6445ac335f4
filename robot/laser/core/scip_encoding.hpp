#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Hokuyo's Sensor Communication Interface Protocol, version 2.x: ASCII lines, each ended by a line feed.
///
/// A request is a command, parameters of fixed width, and perhaps ";" and a tag. A reply is the echo of the request, a
/// status line, data lines and an empty line. Source: the published SCIP 2.0 specification and the vendor's open
/// library.
namespace tandem::scip {

/// The character that closes a status or data line: the low six bits of the sum of `text`, as one character.
[[nodiscard]] char checksum(std::string_view text);

/// `value` as `characters` characters of six bits each, most significant first; higher bits are cut off.
[[nodiscard]] std::string encode_number(std::uint32_t value, std::size_t characters);

/// The inverse of encode_number; none if a character is outside '0'..'o' or there are none or more than five of them.
[[nodiscard]] std::optional<std::uint32_t> decode_number(std::string_view characters);

/// `value` in exactly `digits` decimal digits, as parameters are written; 0 <= value < 10^digits.
[[nodiscard]] std::string decimal(int value, std::size_t digits);

/// The number that `digits` are, all of them decimal digits.
[[nodiscard]] std::optional<int> parse_decimal(std::string_view digits);

}  // namespace tandem::scip
