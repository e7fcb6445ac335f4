#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/laser/core/device_clock.hpp"
#include "robot/laser/core/laser_config.hpp"
#include "robot/laser/core/laser_reading.hpp"
#include "robot/laser/core/laser_session.hpp"
#include "robot/laser/core/reconnection.hpp"
#include "robot/laser/core/scan_filter.hpp"
#include "robot/laser/core/scan_watch.hpp"
#include "robot/link/byte_link.hpp"
#include "services/common/clock.hpp"

namespace tandem {

/// How the laser is, in a word and a sentence.
struct LaserCondition {
  enum class State { Opening, Streaming, Lost };
  State state = State::Opening;
  std::string reason;  ///< empty while it streams

  friend bool operator==(const LaserCondition&, const LaserCondition&) = default;
};

/// Keeps a link to a sensor open and its scans coming: the session decides, this reads and writes.
class LaserDriver {
 public:
  /// `timer` paces the talk with the device and its time-outs; scans are stamped with `mission`. Throws ConfigError on
  /// a device that is none.
  LaserDriver(const LaserConfig& config, Clock& timer, const Clock& mission);
  ~LaserDriver() { stop(); }
  LaserDriver(const LaserDriver&) = delete;
  LaserDriver& operator=(const LaserDriver&) = delete;

  /// The scans that came; waits for bytes, or for the next try to open the device, at most 50 ms.
  [[nodiscard]] std::vector<LaserReading> step();
  [[nodiscard]] const LaserCondition& condition() const { return condition_; }
  /// What is wrong with the sensor or its scans while they stream; empty when nothing is.
  [[nodiscard]] std::string complaint() const;
  /// Which sensor it is, once it streams.
  [[nodiscard]] const std::string& identity() const { return identity_; }
  /// Damaged replies and wrong scans since the start.
  [[nodiscard]] std::uint64_t damaged() const { return damaged_before_ + (session_ ? session_->damaged() : 0); }
  /// Darkens the laser and closes the link.
  void stop();

 private:
  void open();
  void lose(std::string reason);
  [[nodiscard]] LaserReading stamped(DeviceScan scan, Time received);

  LaserConfig config_;
  Clock& timer_;
  const Clock& mission_;
  std::optional<ByteLink> link_;
  std::unique_ptr<LaserSession> session_;
  std::optional<DeviceClock> device_clock_;
  std::optional<ScanWatch> watch_;
  ScanFilter filter_;
  Reconnection reconnection_;
  Time next_try_;
  Time last_mark_{};
  LaserCondition condition_;
  std::string identity_;
  std::uint64_t damaged_before_ = 0;
};

}  // namespace tandem
