#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robot/laser/core/scip.hpp"
#include "services/common/time.hpp"

namespace tandem::simulator {

/// The steps that one value of a scan stands for: with cluster 3 there is one beam for every third step, its middle.
struct ScanBeam {
  double step = 0.0;
};

/// Measures at the given steps during the turn that just ended: [m], NaN where nothing came back.
using Measure = std::function<std::vector<double>(std::span<const ScanBeam>)>;

/// One connection to a Hokuyo sensor: bytes of SCIP 2.0 in and out. The sensor turns at its own rate; whoever owns this
/// tells it when a turn has ended.
class ScipDevice {
 public:
  /// `clock_start_ms` is what its 24-bit millisecond clock shows at `now`.
  ScipDevice(scip::SensorParameters sensor, Time now, std::uint32_t clock_start_ms = 0);

  /// Takes bytes from the host; the answers to them. A single scan (GD) is answered after the next turn.
  [[nodiscard]] std::string receive(std::span<const std::uint8_t> bytes, Time now);
  /// A turn that began at `turn_start` has ended: the scans to send, if any. `measure` is asked only for what is
  /// needed.
  [[nodiscard]] std::string end_turn(Time turn_start, const Measure& measure);

  [[nodiscard]] bool is_measuring() const { return stream_.has_value() || single_.has_value(); }

 private:
  [[nodiscard]] std::string answer(const scip::Request& request, Time now);
  [[nodiscard]] std::string answer_to_scan_request(const scip::Request& request);
  [[nodiscard]] std::string answer_to_time_request(const scip::Request& request, Time now);
  [[nodiscard]] std::vector<std::string> version_lines() const;
  [[nodiscard]] std::vector<std::string> state_lines(Time now) const;
  [[nodiscard]] std::uint32_t clock_ms(Time time) const;
  [[nodiscard]] scip::ScanData scan(const scip::ScanRequest& request, Time turn_start, const Measure& measure) const;

  scip::SensorParameters sensor_;
  Time started_;
  std::uint32_t clock_start_ms_;
  scip::LineReader reader_{true};
  bool laser_on_ = false;
  bool adjusting_time_ = false;
  std::optional<scip::ScanRequest> stream_;
  int turns_to_skip_ = 0;
  int scans_left_ = 0;  ///< 0: endless
  std::optional<scip::ScanRequest> single_;
};

}  // namespace tandem::simulator
