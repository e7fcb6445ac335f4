#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "robot/laser/core/cola_scan.hpp"
#include "robot/laser/core/laser_config.hpp"
#include "robot/laser/core/laser_session.hpp"
#include "services/common/time.hpp"

namespace tandem {

/// The conversation with a SICK LMS 1xx, LMS 5xx or TiM in CoLa A: who it is, login, how it is, what to send, run,
/// scans.
///
/// Nothing is written to its EEPROM. A device that was switched on warms up for up to a minute: it is waited for.
class ColaSession final : public LaserSession {
 public:
  ColaSession(const LaserConfig& config, Time opened);

  [[nodiscard]] Output step(std::span<const std::uint8_t> received, Time now) override;
  [[nodiscard]] std::string farewell() const override { return cola::bytes_of("sEN LMDscandata 0"); }
  [[nodiscard]] std::uint64_t damaged() const override { return reader_.damaged() + bad_scans_; }

 private:
  /// In the order in which they are asked. An LMS tells its state, a TiM another one.
  enum class Phase { Quiet, Identity, Login, Content, Measure, Run, State, TimState, Start, Stream };

  void enter(Phase phase, Output& output, Time now);
  void ask(Output& output, Time now);
  void take(std::string_view text, Output& output, Time now);
  void take_refusal(Output& output, Time now);
  void take_state(const cola::Words& words, Output& output, Time now);
  void take_scan(std::string_view text, Output& output, Time now);
  void watch_the_time(Output& output, Time now);
  [[nodiscard]] std::string request() const;

  LaserConfig config_;
  cola::TelegramReader reader_;
  std::uint64_t bad_scans_ = 0;

  Phase phase_ = Phase::Quiet;
  bool has_begun_ = false;
  bool is_warming_up_ = false;
  Time asked_at_;
  Time state_since_{};
  int tries_ = 0;
  Time last_scan_{};
};

}  // namespace tandem
