#pragma once

#include <cstdint>
#include <deque>
#include <span>

#include "robot/pioneer/core/packet.hpp"
#include "services/common/random.hpp"
#include "services/common/time.hpp"
#include "services/simulator/core/hardware_fault.hpp"

namespace tandem::simulator {

/// The serial line between the host and a simulated controller, and what a fault makes of its bytes.
///
/// Stuck repeats the last standard packet, Wrong displaces its counters, Slow lets one packet in five through, Delayed
/// holds bytes back for 0.4 s, Intermittent lets nothing through in every second second. Noise, and bytes that come in
/// parts, are no fault: any line has them, and a driver must not mind.
class BaseLine {
 public:
  explicit BaseLine(std::uint64_t seed) : rng_(seed) {}

  void set_fault(HardwareFault fault, Time now);
  [[nodiscard]] HardwareFault fault() const { return fault_; }
  /// So many of the packets to the host get a wrong byte [0, 1], and so many garbage before them.
  void set_noise(double share) { noise_ = share; }

  /// What of the host's `bytes` reaches the controller.
  [[nodiscard]] pioneer::Bytes to_controller(std::span<const std::uint8_t> bytes, Time now);
  /// What reaches the host at `now`, if the controller sends `packet` now; an empty one asks for what was held back.
  [[nodiscard]] pioneer::Bytes to_host(pioneer::Bytes packet, Time now);

 private:
  [[nodiscard]] bool is_cut(Time now) const;
  [[nodiscard]] pioneer::Bytes spoiled(pioneer::Bytes packet);
  void add_noise(pioneer::Bytes& packet);

  struct Held {
    pioneer::Bytes bytes;
    Time until{};
  };
  Rng rng_;
  HardwareFault fault_ = HardwareFault::None;
  Time since_{};
  double noise_ = 0.0;
  pioneer::Bytes last_;  ///< standard packet
  int packets_ = 0;
  std::deque<Held> held_;
};

}  // namespace tandem::simulator
