#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robot/laser/core/scip_request.hpp"

namespace tandem::scip {

/// One answer of the sensor, every checksum of it checked.
struct Reply {
  std::string echo = {};               ///< The request it answers, with its tag.
  std::string status = {};             ///< "00" good, "99" a streamed scan; "E" or "0" of a SCIP 1.1 sensor.
  std::vector<std::string> data = {};  ///< Data lines without what closes them.
};

/// Puts replies together from bytes; damaged ones are dropped and counted.
class ReplyParser {
 public:
  /// The replies that `bytes` complete.
  [[nodiscard]] std::vector<Reply> take(std::span<const std::uint8_t> bytes);
  /// Replies with a wrong checksum or shape, such as the rest of one that began before we listened.
  [[nodiscard]] std::uint64_t damaged() const { return damaged_; }

 private:
  LineReader reader_;
  std::vector<std::string> lines_;
  std::uint64_t damaged_ = 0;
};

/// The bytes of a reply; `data` lines get their checksum, those of VV, PP and II their ";" too.
[[nodiscard]] std::string bytes_of(const Reply& reply);

/// One scan as the wire has it.
struct ScanData {
  ScanRequest request = {};                     ///< count: how many scans are left of the stream.
  std::uint32_t timestamp_ms = 0;               ///< 24 bits, at the index mark; wraps after 4 h 40 min.
  std::vector<std::uint32_t> ranges_mm = {};    ///< Values below DMIN are error codes.
  std::vector<std::uint32_t> intensities = {};  ///< ME and GE only.

  friend bool operator==(const ScanData&, const ScanData&) = default;
};

/// The bytes of a reply with a scan: status 99 to a stream, 00 to a single request.
[[nodiscard]] std::string bytes_of(const ScanData& scan);

/// The scan in `reply`; none if it carries none, or not exactly as many values as its echo says.
[[nodiscard]] std::optional<ScanData> parse_scan(const Reply& reply);

/// The answer to TM1: the sensor's clock.
[[nodiscard]] std::string timestamp_data(std::uint32_t timestamp_ms);

}  // namespace tandem::scip
