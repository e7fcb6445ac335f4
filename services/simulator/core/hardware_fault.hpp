#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include "services/common/random.hpp"
#include "services/common/time.hpp"

namespace tandem::simulator {

/// What can be made to go wrong with a simulated device while it runs.
enum class HardwareFault {
  None,
  Off,           ///< No power: hears nothing, says nothing; forgets everything.
  Stuck,         ///< Goes on, but measures nothing new.
  Garbage,       ///< Noise on the line to the host.
  Wrong,         ///< Measures what is not so.
  Slow,          ///< Every fourth message alone.
  Delayed,       ///< All that it says arrives 0.4 s late.
  Intermittent,  ///< A loose plug: out for a second, in for one; what it cuts off arrives half.
};

/// The fault's name, "none", "off", "stuck", ... , and the inverse.
[[nodiscard]] std::string_view name_of(HardwareFault fault);
[[nodiscard]] std::optional<HardwareFault> hardware_fault(std::string_view name);
/// All names, for messages: "none, off, ...".
[[nodiscard]] std::string hardware_fault_names();

/// The line between a simulated device and its host, with what goes wrong on it. Stuck and Wrong are the device's own:
/// who measures asks for them.
class FaultyLine {
 public:
  explicit FaultyLine(std::uint64_t seed) : rng_(seed) {}

  void set(HardwareFault fault, Time now);
  [[nodiscard]] HardwareFault fault() const { return fault_; }
  /// So many of the messages to the host get a wrong byte [0, 1], and so many garbage before them. No fault: any serial
  /// line is noisy, and a driver must not mind.
  void set_noise(double share) { noise_ = share; }

  /// True when what the host sends now reaches the device.
  [[nodiscard]] bool hears(Time now) const { return is_joined(now); }
  /// What of the device's `bytes` goes on to the host: an answer, at once.
  [[nodiscard]] std::string pass(std::string bytes, Time now);
  /// As pass(), of a message that the device sends unasked, again and again: a scan, a report.
  [[nodiscard]] std::string pass_message(std::string bytes, Time now);
  /// What was held back and is due now.
  [[nodiscard]] std::string due(Time now);

 private:
  struct Held {
    Time until;
    std::string bytes;
  };
  [[nodiscard]] bool is_joined(Time now) const;
  void add_noise(std::string& bytes);

  Rng rng_;
  HardwareFault fault_ = HardwareFault::None;
  double noise_ = 0.0;
  Time since_{};
  std::uint64_t messages_ = 0;
  bool was_joined_ = true;
  std::deque<Held> held_;
};

}  // namespace tandem::simulator
