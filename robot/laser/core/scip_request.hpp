#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "robot/laser/core/scip_sensor.hpp"

namespace tandem::scip {

/// Cuts a stream of bytes into lines, however it is split in reading.
///
/// LF ends a line; a lone CR or CR LF does too, if `carriage_return_ends`. A line longer than `kMostCharacters` is cut.
class LineReader {
 public:
  static constexpr std::size_t kMostCharacters = 4096;
  explicit LineReader(bool carriage_return_ends = false) : carriage_return_ends_(carriage_return_ends) {}
  /// The lines that `bytes` complete, without their ends.
  [[nodiscard]] std::vector<std::string> take(std::span<const std::uint8_t> bytes);

 private:
  bool carriage_return_ends_;
  bool after_carriage_return_ = false;
  std::string line_;
};

/// A request as the sensor takes it apart.
struct Request {
  std::string line;        ///< All of it, as the reply echoes it.
  std::string command;     ///< "MD", "QT", "TM", ...; "SCIP2.0" is one too.
  std::string parameters;  ///< What follows the command.
  std::string tag;         ///< What follows ";", which the echo repeats.
};

/// `line` taken apart; none if it is shorter than a command.
[[nodiscard]] std::optional<Request> parse_request(const std::string& line);

/// Asks for scans: MD, MS, ME stream them; GD, GS, GE give one.
struct ScanRequest {
  std::string command = "MD";  ///< Second letter: D three characters per range, S two, E range and intensity.
  int first_step = 0;
  int last_step = 0;
  int cluster = 1;  ///< So many neighbouring steps make one value, their least; 0 and 1: each step.
  int skip = 0;     ///< So many turns are left out after each scan; streams only.
  int count = 0;    ///< So many scans, 0 for ever; streams only. In a reply: how many are left.
  std::string tag = {};

  friend bool operator==(const ScanRequest&, const ScanRequest&) = default;
};

/// The request, or the echo of a reply to it, as a line without its end: "MD0000108003300".
[[nodiscard]] std::string line_of(const ScanRequest& request);

/// The scan request in `request`, or the two-character status that refuses it; steps are not checked against a sensor.
[[nodiscard]] std::variant<ScanRequest, std::string> parse_scan_request(const Request& request);
/// As above, and its steps must lie in the sensor's field of view.
[[nodiscard]] std::variant<ScanRequest, std::string> parse_scan_request(const Request& request,
                                                                        const SensorParameters& sensor);

/// True for the commands that stream (M.) or give one scan (G.).
[[nodiscard]] bool is_stream(std::string_view command);
[[nodiscard]] bool is_single(std::string_view command);

/// Steps in one value, at least 1.
[[nodiscard]] int steps_per_value(const ScanRequest& request);
/// Values in one scan: the last may stand for fewer steps than the others.
[[nodiscard]] std::size_t value_count(const ScanRequest& request);

}  // namespace tandem::scip
