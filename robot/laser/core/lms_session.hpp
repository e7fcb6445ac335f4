#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "robot/laser/core/laser_config.hpp"
#include "robot/laser/core/laser_session.hpp"
#include "robot/laser/core/lms_message.hpp"
#include "services/common/time.hpp"

namespace tandem {

/// The conversation with a SICK LMS 2xx: quiet, who and how it is, how its values are meant, field of view, rate,
/// scans.
///
/// The configuration in its flash is written only if it differs from what is asked for. The line's rate is left alone
/// where there is none to set, behind a serial server.
class LmsSession final : public LaserSession {
 public:
  /// The line is at `baud_rate` now; 0: its rate cannot be set.
  LmsSession(const LaserConfig& config, Time opened, int baud_rate);

  [[nodiscard]] Output step(std::span<const std::uint8_t> received, Time now) override;
  [[nodiscard]] std::string farewell() const override;
  [[nodiscard]] std::uint64_t damaged() const override { return reader_.damaged() + bad_scans_; }

 private:
  /// In the order in which they are asked.
  enum class Phase {
    Quiet,
    Type,
    Status,
    ReadConfig,
    Installation,
    WriteConfig,
    Variant,
    Rate,
    Settle,
    Verify,
    Start,
    Stream
  };

  void enter(Phase phase, Output& output, Time now);
  void ask(Output& output, Time now);
  void take(const lms::Payload& payload, Output& output, Time now);
  void take_mode_answer(const lms::Payload& payload, Output& output, Time now);
  void take_config(const lms::Payload& payload, Output& output, Time now);
  void take_scan(const lms::Payload& payload, Output& output, Time now);
  void watch_the_time(Output& output, Time now);
  [[nodiscard]] lms::Payload request() const;
  [[nodiscard]] lms::RangeFormat wanted_format() const;
  [[nodiscard]] bool must_switch_rate() const;

  LaserConfig config_;
  int baud_rate_;
  int wanted_rate_;
  lms::Variant variant_;
  lms::TelegramReader reader_{lms::kFromLaser};
  std::uint64_t bad_scans_ = 0;

  Phase phase_ = Phase::Quiet;
  bool has_begun_ = false;
  Time asked_at_;
  int tries_ = 0;
  lms::ConfigBlock block_;
  lms::RangeFormat format_;
  Time last_scan_{};
};

}  // namespace tandem
