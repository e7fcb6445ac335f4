#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "robot/laser/core/lms_message.hpp"
#include "services/simulator/core/laser_device.hpp"

namespace tandem::simulator {

/// How a simulated LMS 2xx comes from the factory.
struct LmsOptions {
  std::string type = "LMS200;30106;V02.10";
  bool polluted = false;  ///< Its window is dirty.
};

/// A SICK LMS 2xx on a serial line: wakes at 9600 baud, understands and says nothing sensible at a wrong rate, and
/// sends a scan only when the line has carried the last one away.
class LmsDevice final : public LaserDevice {
 public:
  LmsDevice(LmsOptions options, Time now);

  [[nodiscard]] std::string receive(std::span<const std::uint8_t> bytes, Time now) override;
  [[nodiscard]] std::string end_turn(Time turn_start, const Measure& measure) override;
  [[nodiscard]] bool is_measuring() const override { return streaming_ || single_ || !announced_; }
  [[nodiscard]] Duration turn_period() const override;
  void set_line_rate(int baud_rate) override { line_rate_ = baud_rate; }

  [[nodiscard]] int baud_rate() const { return baud_rate_; }
  /// How often its flash was written.
  [[nodiscard]] int flash_writes() const { return flash_writes_; }

 private:
  [[nodiscard]] std::string answer(const lms::Payload& request);
  [[nodiscard]] std::string answer_to_mode(const lms::Payload& request);
  [[nodiscard]] std::string answer_to_variant(const lms::Payload& request);
  [[nodiscard]] std::string answer_to_write(const lms::Payload& request);
  [[nodiscard]] lms::Payload status_payload() const;
  [[nodiscard]] std::string telegram(lms::Payload payload) const;
  [[nodiscard]] std::string on_the_line(std::string bytes) const;
  [[nodiscard]] lms::ScanData scan(const Measure& measure) const;
  [[nodiscard]] bool is_heard() const { return line_rate_ == 0 || line_rate_ == baud_rate_; }

  LmsOptions options_;
  lms::TelegramReader reader_{lms::kToLaser};
  lms::Variant variant_;
  lms::ConfigBlock block_;
  int baud_rate_;
  int line_rate_ = 0;
  bool announced_ = false;
  bool installing_ = false;
  bool streaming_ = false;
  bool single_ = false;
  int flash_writes_ = 0;
  Time line_free_;
};

}  // namespace tandem::simulator
