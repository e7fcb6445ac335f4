#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/laser/core/lms_telegram.hpp"

/// What the telegrams of the LMS 2xx say: the first byte of a payload is a command; the answer to it is that plus 0x80.
namespace tandem::lms {

namespace command {
inline constexpr std::uint8_t kReset = 0x10;
inline constexpr std::uint8_t kMode = 0x20;
inline constexpr std::uint8_t kScan = 0x30;
inline constexpr std::uint8_t kStatus = 0x31;
inline constexpr std::uint8_t kType = 0x3A;
inline constexpr std::uint8_t kVariant = 0x3B;
inline constexpr std::uint8_t kReadConfig = 0x74;
inline constexpr std::uint8_t kWriteConfig = 0x77;
/// In the laser's answer; PowerOn comes unasked.
inline constexpr std::uint8_t kAnswer = 0x80;
inline constexpr std::uint8_t kPowerOn = 0x90;
}  // namespace command

namespace mode {
inline constexpr std::uint8_t kInstallation = 0x00;  ///< with the password
inline constexpr std::uint8_t kStream = 0x24;
inline constexpr std::uint8_t kOnRequest = 0x25;
}  // namespace mode

inline constexpr std::string_view kPassword = "SICK_LMS";

/// The mode that sets the line to `baud_rate`; none for a rate the laser does not have.
[[nodiscard]] std::optional<std::uint8_t> mode_of_rate(int baud_rate);
/// The inverse.
[[nodiscard]] std::optional<int> rate_of_mode(std::uint8_t mode);

/// Field of view and step of a scan. A quarter degree exists with 100 degrees only.
struct Variant {
  int field_deg = 180;     ///< 180 or 100
  int step_centideg = 50;  ///< 100, 50 or 25

  friend bool operator==(const Variant&, const Variant&) = default;
};
[[nodiscard]] bool exists(const Variant& variant);
[[nodiscard]] std::size_t value_count(const Variant& variant);
/// Turns of the mirror for one scan: it steps by a degree, and each turn fills in between.
[[nodiscard]] int turns_per_scan(const Variant& variant);
/// One turn of the mirror [s].
inline constexpr double kTurnPeriod_s = 1.0 / 75.0;

/// How the 16 bits of a value are meant: the measuring mode and the unit of the laser's configuration.
struct RangeFormat {
  std::uint8_t measuring_mode = 0;
  bool millimetres = true;

  friend bool operator==(const RangeFormat&, const RangeFormat&) = default;
};
/// How many low bits of a value are the range; those above are flags.
[[nodiscard]] int range_bits(const RangeFormat& format);
/// True where the flags are the strength of the echo.
[[nodiscard]] bool has_intensity(const RangeFormat& format);
/// The greatest range that is one [m]: the few values at the top are error codes.
[[nodiscard]] double range_max_m(const RangeFormat& format);

/// The block of settings that reads and writes of the configuration carry, without command and status.
using ConfigBlock = std::vector<std::uint8_t>;
inline constexpr std::size_t kLeastConfigBlock = 7;
/// The format that is set in `block`, which has at least kLeastConfigBlock bytes.
[[nodiscard]] RangeFormat format_of(const ConfigBlock& block);
[[nodiscard]] ConfigBlock with_format(ConfigBlock block, const RangeFormat& format);

/// Requests.
[[nodiscard]] Payload mode_request(std::uint8_t mode);
[[nodiscard]] Payload variant_request(const Variant& variant);

/// One scan as the wire has it, from the right.
struct ScanData {
  bool millimetres = true;
  std::vector<std::uint16_t> values = {};  ///< range and flags
  std::uint8_t status = 0;

  friend bool operator==(const ScanData&, const ScanData&) = default;
};
/// The scan in an answer; none if it is no whole scan, or has not as many values as it says.
[[nodiscard]] std::optional<ScanData> parse_scan(const Payload& payload);
[[nodiscard]] Payload payload_of(const ScanData& scan);

/// What a status byte complains of; empty when all is well.
[[nodiscard]] std::string complaint_of(std::uint8_t status);
inline constexpr std::uint8_t kPolluted = 0x80;

}  // namespace tandem::lms
