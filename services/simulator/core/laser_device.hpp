#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "services/common/time.hpp"
#include "services/simulator/core/laser_view.hpp"

namespace tandem::simulator {

/// Measures along the given beams during the turn that just ended: [m], NaN where nothing came back.
using Measure = std::function<std::vector<double>(std::span<const Beam>)>;

/// A simulated laser with one host: bytes of its protocol in and out. The mirror turns at its own rate; whoever owns
/// this tells it when a turn has ended.
class LaserDevice {
 public:
  virtual ~LaserDevice() = default;

  /// Takes bytes from the host; what to send to it at once.
  [[nodiscard]] virtual std::string receive(std::span<const std::uint8_t> bytes, Time now) = 0;
  /// A turn that began at `turn_start` has ended: the scans to send, if any. `measure` is asked only for what is
  /// needed.
  [[nodiscard]] virtual std::string end_turn(Time turn_start, const Measure& measure) = 0;
  [[nodiscard]] virtual bool is_measuring() const = 0;
  /// From one end of a turn to the next.
  [[nodiscard]] virtual Duration turn_period() const = 0;
  /// The rate of the host's serial line [baud]; 0, as at first, where the line has none.
  virtual void set_line_rate(int /*baud_rate*/) {}
};

/// A laser of `model` that was switched on at `now`; none if the model is not known.
[[nodiscard]] std::unique_ptr<LaserDevice> make_laser_device(const std::string& model, Time now);
/// The models there are.
[[nodiscard]] const std::vector<std::string>& laser_models();

}  // namespace tandem::simulator
