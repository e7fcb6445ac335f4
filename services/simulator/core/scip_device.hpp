#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robot/laser/core/scip.hpp"
#include "services/common/time.hpp"
#include "services/simulator/core/laser_device.hpp"

namespace tandem::simulator {

/// What a simulated Hokuyo sensor is.
struct ScipOptions {
  scip::SensorParameters parameters = scip::utm_30lx();
  bool has_intensities = true;
  bool wakes_in_version_1 = false;   ///< Answers with E until it is told SCIP2.0.
  int baud_rate = 0;                 ///< Of its serial line as it wakes; 0: it has none whose rate matters.
  std::string status = "00";         ///< Of what lights the laser; "0L": abnormal, until it is rebooted.
  std::uint32_t clock_start_ms = 0;  ///< What its 24-bit millisecond clock shows at first.
};
[[nodiscard]] ScipOptions urg_04lx_serial();

/// One connection to a Hokuyo sensor: bytes of SCIP 2.0 in and out.
class ScipDevice final : public LaserDevice {
 public:
  ScipDevice(ScipOptions options, Time now);

  /// A single scan (GD) is answered after the next turn.
  [[nodiscard]] std::string receive(std::span<const std::uint8_t> bytes, Time now) override;
  [[nodiscard]] std::string end_turn(Time turn_start, const Measure& measure) override;
  [[nodiscard]] Duration turn_period() const override { return from_seconds(scip::turn_period_s(sensor_)); }
  void set_line_rate(int baud_rate) override { line_rate_ = baud_rate; }
  [[nodiscard]] int baud_rate() const { return baud_rate_; }
  [[nodiscard]] bool is_measuring() const override { return stream_.has_value() || single_.has_value(); }

 private:
  [[nodiscard]] std::string answer(const scip::Request& request, Time now);
  [[nodiscard]] std::string answer_to_light(const scip::Request& request);
  [[nodiscard]] std::string answer_to_rate(const scip::Request& request);
  [[nodiscard]] std::string answer_to_reset(const scip::Request& request, Time now);
  [[nodiscard]] std::string answer_to_reboot(const scip::Request& request, Time now);
  [[nodiscard]] bool minds_the_rate() const { return options_.baud_rate != 0 && line_rate_ != 0; }
  [[nodiscard]] bool is_heard() const { return !minds_the_rate() || line_rate_ == baud_rate_; }
  [[nodiscard]] std::string on_the_line(std::string bytes) const;
  [[nodiscard]] std::string answer_to_scan_request(const scip::Request& request);
  [[nodiscard]] std::string answer_to_time_request(const scip::Request& request, Time now);
  [[nodiscard]] std::vector<std::string> version_lines() const;
  [[nodiscard]] std::vector<std::string> state_lines(Time now) const;
  [[nodiscard]] std::uint32_t clock_ms(Time time) const;
  [[nodiscard]] std::string next_of_stream(Time turn_start, const Measure& measure);
  [[nodiscard]] scip::ScanData scan(const scip::ScanRequest& request, Time turn_start, const Measure& measure) const;

  ScipOptions options_;
  scip::SensorParameters sensor_;
  Time started_;
  std::uint32_t clock_start_ms_;
  bool in_version_1_;
  int baud_rate_;
  int line_rate_ = 0;
  Time line_free_;
  std::optional<Time> reboot_asked_;
  scip::LineReader reader_{true};
  bool laser_on_ = false;
  bool adjusting_time_ = false;
  std::optional<scip::ScanRequest> stream_;
  int turns_to_skip_ = 0;
  int scans_left_ = 0;  ///< 0: endless
  std::optional<scip::ScanRequest> single_;
};

}  // namespace tandem::simulator
