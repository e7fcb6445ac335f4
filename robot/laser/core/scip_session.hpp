#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robot/laser/core/laser_config.hpp"
#include "robot/laser/core/laser_session.hpp"
#include "robot/laser/core/scip.hpp"
#include "services/common/time.hpp"

namespace tandem {

/// The conversation with a Hokuyo sensor: QT until it is quiet, RS, VV, PP, II, SS where a rate is asked for, BM, MD.
///
/// RS is left out where a rate is asked for: it would put the line back to the sensor's own.
class ScipSession final : public LaserSession {
 public:
  /// The line is at `baud_rate` now; 0: its rate cannot be set.
  ScipSession(const LaserConfig& config, Time opened, int baud_rate);

  [[nodiscard]] Output step(std::span<const std::uint8_t> received, Time now) override;
  /// The laser goes dark.
  [[nodiscard]] std::string farewell() const override { return "QT\n"; }
  [[nodiscard]] std::uint64_t damaged() const override { return parser_.damaged() + bad_scans_; }

 private:
  /// The requests in their order; Quiet is QT and then silence.
  enum class Phase { Quiet, Reset, Version, Parameters, Status, Rate, Settle, Light, Start, Stream };

  void ask(const std::string& line, Output& output, Time now);
  void enter(Phase phase, Output& output, Time now);
  void advance(Output& output, Time now);
  void take_reply(const scip::Reply& reply, Output& output, Time now);
  void take_quiet_reply(const scip::Reply& reply, Output& output, Time now);
  void take_streamed(const scip::Reply& reply, Output& output, Time now);
  void take_parameters(const scip::Reply& reply, Output& output, Time now);
  void take_status(const scip::Reply& reply, Output& output, Time now);
  void take_rate(const scip::Reply& reply, Output& output, Time now);
  void take_light(const scip::Reply& reply, Output& output, Time now);
  void take_start(const scip::Reply& reply, Output& output, Time now);
  void reboot(Output& output);
  void watch_the_time(Output& output, Time now);
  [[nodiscard]] bool must_switch_rate() const;
  [[nodiscard]] std::string request_of(Phase phase) const;
  [[nodiscard]] bool is_from_our_stream(const scip::Reply& reply) const;

  LaserConfig config_;
  int baud_rate_;
  std::optional<scip::SensorParameters> sensor_;
  scip::ReplyParser parser_;
  std::uint64_t bad_scans_ = 0;

  Phase phase_ = Phase::Quiet;
  bool has_begun_ = false;
  std::string asked_;  ///< the request whose echo is awaited
  Time asked_at_{};
  int tries_ = 0;
  bool quit_answered_ = false;
  Time last_byte_{};
  Time last_scan_{};
  scip::ScanRequest stream_;
};

}  // namespace tandem
