#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robot/laser/core/laser_config.hpp"
#include "robot/laser/core/scip.hpp"
#include "services/common/time.hpp"

namespace tandem {

/// One conversation with a sensor, from the opened link to the stream of scans: QT until it is quiet, RS, VV, PP, II,
/// BM, MD. Bytes and time in, bytes and scans out; it knows no socket. When it has failed, close the link and begin
/// another.
class ScipSession {
 public:
  enum class State { Opening, Streaming, Failed };

  struct Output {
    std::string send;                   ///< to the sensor
    std::vector<scip::ScanData> scans;  ///< complete, in order; first_step, last_step and cluster as asked for
  };

  ScipSession(const LaserConfig& config, Time opened);

  /// To be called with what came, also if nothing did, at least every 50 ms.
  [[nodiscard]] Output step(std::span<const std::uint8_t> received, Time now);

  [[nodiscard]] State state() const { return state_; }
  /// What it waits for, or why it failed; empty while it streams.
  [[nodiscard]] const std::string& reason() const { return reason_; }
  /// True once the sensor has answered anything: the device is one, at this rate.
  [[nodiscard]] bool was_answered() const { return was_answered_; }
  /// What the sensor said of itself; known while it streams.
  [[nodiscard]] const std::optional<scip::SensorParameters>& sensor() const { return sensor_; }
  /// Product, firmware and serial number, for the log.
  [[nodiscard]] const std::string& identity() const { return identity_; }
  /// Replies that were damaged, and scans that did not have the right number of values.
  [[nodiscard]] std::uint64_t damaged() const { return parser_.damaged() + bad_scans_; }

  /// What to send before the link is closed on purpose: stops the stream, and the laser goes dark.
  [[nodiscard]] static std::string farewell() { return "QT\n"; }

 private:
  /// The requests in their order; Quiet is QT and then silence.
  enum class Phase { Quiet, Reset, Version, Parameters, Status, Light, Start, Stream };

  void ask(const std::string& line, Output& output, Time now);
  void enter(Phase phase, Output& output, Time now);
  void advance(Output& output, Time now);
  void take_reply(const scip::Reply& reply, Output& output, Time now);
  void take_quiet_reply(const scip::Reply& reply, Output& output, Time now);
  void take_streamed(const scip::Reply& reply, Output& output, Time now);
  void take_parameters(const scip::Reply& reply, Output& output, Time now);
  void take_light(const scip::Reply& reply, Output& output, Time now);
  void take_start(const scip::Reply& reply, Output& output, Time now);
  void watch_the_time(Output& output, Time now);
  [[nodiscard]] std::string request_of(Phase phase) const;
  [[nodiscard]] bool is_from_our_stream(const scip::Reply& reply) const;
  void fail(std::string reason);

  LaserConfig config_;
  State state_ = State::Opening;
  std::string reason_;
  bool was_answered_ = false;
  std::optional<scip::SensorParameters> sensor_;
  std::string identity_;
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
