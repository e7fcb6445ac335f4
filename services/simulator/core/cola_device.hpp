#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "robot/laser/core/cola_scan.hpp"
#include "services/simulator/core/laser_device.hpp"

namespace tandem::simulator {

/// What a simulated SICK laser with CoLa A is.
struct ColaOptions {
  std::string identity = "LMS111 V1.30";
  bool is_tim = false;  ///< A TiM measures by itself and tells another state than an LMS.
  double first_deg = -45.0;
  double last_deg = 225.0;
  double step_deg = 0.5;
  double rate_hz = 50.0;
  double range_max_m = 20.0;
  int status = 0;         ///< 2: its window is getting dirty.
  Duration warm_up = {};  ///< Not ready for so long after it got power.
};
[[nodiscard]] ColaOptions lms111();
[[nodiscard]] ColaOptions tim561();

/// One connection to a SICK LMS 1xx or TiM: texts of CoLa A in and out. Settings need a login.
class ColaDevice final : public LaserDevice {
 public:
  ColaDevice(ColaOptions options, Time now);

  [[nodiscard]] std::string receive(std::span<const std::uint8_t> bytes, Time now) override;
  [[nodiscard]] std::string end_turn(Time turn_start, const Measure& measure) override;
  [[nodiscard]] bool is_measuring() const override { return streaming_ || single_; }
  [[nodiscard]] Duration turn_period() const override { return from_seconds(1.0 / options_.rate_hz); }

 private:
  [[nodiscard]] std::string answer(const cola::Words& words, Time now);
  [[nodiscard]] std::string answer_to_read(std::string_view name, Time now);
  [[nodiscard]] std::string answer_to_method(const cola::Words& words);
  [[nodiscard]] std::string answer_to_content(const cola::Words& words);
  [[nodiscard]] bool is_ready(Time now) const;
  [[nodiscard]] std::uint32_t clock_us(Time time) const;
  [[nodiscard]] cola::ScanData scan(Time turn_start, const Measure& measure);

  ColaOptions options_;
  Time started_;
  cola::TelegramReader reader_;
  bool logged_in_ = false;
  bool measuring_ = true;
  bool with_strengths_ = false;
  bool streaming_ = false;
  bool single_ = false;
  std::uint32_t scans_ = 0;
};

}  // namespace tandem::simulator
