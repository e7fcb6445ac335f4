#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// SICK's telegrams of the LMS 2xx family (LMS 200, 220, 291) on a serial line.
///
/// A telegram is 0x02, an address, the length of the payload, the payload and a CRC, numbers little-endian. The laser
/// answers each first with one byte: acknowledged or refused. Source: the protocol's open drivers.
namespace tandem::lms {

using Payload = std::vector<std::uint8_t>;

/// The address on telegrams to the laser, and on those from it.
inline constexpr std::uint8_t kToLaser = 0x00;
inline constexpr std::uint8_t kFromLaser = 0x80;

inline constexpr std::uint8_t kAcknowledged = 0x06;
inline constexpr std::uint8_t kRefused = 0x15;

/// A scan of 401 values with all that may stand around them.
inline constexpr std::size_t kMostPayload = 1 + 2 + 2 * 401 + 2 + 1;

/// The CRC over everything of a telegram that stands before it; no standard one: each byte enters beside the one
/// before.
[[nodiscard]] std::uint16_t checksum(std::span<const std::uint8_t> bytes);

/// The bytes of a telegram.
[[nodiscard]] std::string bytes_of(std::uint8_t address, std::span<const std::uint8_t> payload);

/// What the line carries: one of the single bytes, or a telegram.
struct Event {
  enum class Kind { Acknowledged, Refused, Telegram };
  Kind kind = Kind::Telegram;
  Payload payload = {};  ///< of a telegram
};

/// Puts events together from bytes, however they are split in reading. What begins like a telegram and is none costs
/// its first byte only: a telegram inside it is found.
class TelegramReader {
 public:
  /// Reads telegrams that carry `address`.
  explicit TelegramReader(std::uint8_t address) : address_(address) {}

  /// The events that `bytes` complete.
  [[nodiscard]] std::vector<Event> take(std::span<const std::uint8_t> bytes);
  /// Telegrams with a wrong CRC or an impossible length.
  [[nodiscard]] std::uint64_t damaged() const { return damaged_; }

 private:
  std::uint8_t address_;
  std::vector<std::uint8_t> waiting_;
  std::uint64_t damaged_ = 0;
};

}  // namespace tandem::lms
