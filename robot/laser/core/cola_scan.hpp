#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/laser/core/cola_telegram.hpp"
#include "robot/laser/core/laser_session.hpp"

namespace tandem::cola {

/// What a telegram LMDscandata says.
struct Channel {
  std::string name;    ///< "DIST1", "RSSI1", ...
  float scale = 1.0f;  ///< A value times this plus `offset`: [mm], or a strength.
  float offset = 0.0f;
  std::int32_t start_angle = 0;  ///< Of the first value [1/10000 deg]; 90 deg is straight ahead.
  std::int32_t angle_step = 0;   ///< [1/10000 deg]
  std::vector<std::uint16_t> values = {};

  friend bool operator==(const Channel&, const Channel&) = default;
};

struct ScanData {
  int status = 0;  ///< The second of the two device status words: 0 is good.
  std::uint32_t telegram_count = 0;
  std::uint32_t scan_count = 0;
  std::uint32_t scan_time_us = 0;       ///< The device's clock at the start of the scan.
  std::uint32_t send_time_us = 0;       ///< ... and when it was sent.
  std::uint32_t frequency_centihz = 0;  ///< scans, 1/100 Hz
  std::vector<Channel> channels = {};   ///< Of 16 and of 8 bits.

  friend bool operator==(const ScanData&, const ScanData&) = default;
};

/// The scan in a telegram's text; none if it carries none, or is not whole. What follows the channels, a name and a
/// comment with spaces in them, is not looked at.
[[nodiscard]] std::optional<ScanData> parse_scan(std::string_view text);
/// The text of a telegram; `kind` is sSN or sRA. Channels whose name begins with RSSI are written with 8 bits if all
/// their values have no more.
[[nodiscard]] std::string text_of(const ScanData& scan, std::string_view kind);

/// The distances of the first channel that has them, with the strengths that belong to them; none if there is none.
///
/// 0 and the few values above it are codes, not distances: they are NaN, as what lies beyond `range_max_m`.
[[nodiscard]] std::optional<DeviceScan> device_scan_of(const ScanData& scan, double range_max_m);

/// What a status complains of; empty when all is well.
[[nodiscard]] std::string complaint_of(int status);

}  // namespace tandem::cola
