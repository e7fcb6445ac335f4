#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "robot/laser/core/device_clock.hpp"
#include "robot/laser/core/laser_reading.hpp"
#include "services/common/time.hpp"

namespace tandem {

/// A scan as a session hands it on: all but its time.
struct DeviceScan {
  LaserReading reading;                     ///< first_beam is still to be found
  std::optional<std::uint32_t> clock = {};  ///< What the sensor's clock showed at its mark; none has none.
  ClockFormat clock_format = {};
  Duration least_delay = {};  ///< From the mark to the arrival, at least.
  Duration mark_to_first_beam = {};
  double period_s = 0.0;  ///< From one scan to the next, as the sensor is set.
};

/// One conversation with a sensor, from the opened link to the stream of scans. Bytes and time in, bytes and scans out;
/// it knows no socket. When it has failed, close the link and begin another. One class for each family of sensors.
class LaserSession {
 public:
  enum class State { Opening, Streaming, Failed };

  struct Output {
    std::string send;                   ///< to the sensor
    std::optional<int> baud_rate = {};  ///< the line is to be set to it, after what was to be sent
    std::vector<DeviceScan> scans;      ///< complete, in order
  };

  virtual ~LaserSession() = default;

  /// To be called with what came, also if nothing did, at least every 50 ms.
  [[nodiscard]] virtual Output step(std::span<const std::uint8_t> received, Time now) = 0;
  /// What to send before the link is closed on purpose: stops the stream.
  [[nodiscard]] virtual std::string farewell() const = 0;
  /// Replies that were damaged, and scans that did not have the right number of values.
  [[nodiscard]] virtual std::uint64_t damaged() const = 0;

  [[nodiscard]] State state() const { return state_; }
  /// What it waits for, or why it failed; empty while it streams.
  [[nodiscard]] const std::string& reason() const { return reason_; }
  /// What the sensor itself complains of while it streams; empty when it does not.
  [[nodiscard]] const std::string& warning() const { return warning_; }
  /// True once the sensor has answered anything: the device is one, at this rate.
  [[nodiscard]] bool was_answered() const { return was_answered_; }
  /// Product, firmware and serial number, for the log.
  [[nodiscard]] const std::string& identity() const { return identity_; }

 protected:
  void fail(std::string reason) {
    state_ = State::Failed;
    reason_ = std::move(reason);
  }

  State state_ = State::Opening;
  std::string reason_;
  std::string warning_;
  bool was_answered_ = false;
  std::string identity_;
};

}  // namespace tandem
