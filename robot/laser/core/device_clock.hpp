#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "services/common/time.hpp"

namespace tandem {

/// How a sensor's clock counts.
struct ClockFormat {
  Duration tick = std::chrono::milliseconds{1};
  std::uint32_t most = 0xFFFFFF;  ///< After this it begins again at 0; all bits set.
};

/// Places the sensor's own clock on mission time.
///
/// A scan arrives late by its transmission, never early. So in each second the least of (arrival - sensor's time) is
/// the best one, and a line through these over half a minute gives offset and drift of the sensor's clock.
class DeviceClock {
 public:
  /// `least_delay`: what passes at least between the sensor's stamp and the arrival, the measuring itself.
  explicit DeviceClock(Duration least_delay, const ClockFormat& format = {})
      : least_delay_(least_delay), format_(format) {}

  /// When the sensor's clock showed `count`, on what arrived at `received`.
  ///
  /// Grows from call to call and is never later than `received` less the least delay. A clock that stands still or
  /// jumps is not believed: then arrival alone counts, and the fit begins anew.
  [[nodiscard]] Time mission_time(std::uint32_t count, Time received);

 private:
  struct LeastOffset {
    Duration device_time;
    Duration offset;
  };
  void remember(Duration offset);
  [[nodiscard]] Duration offset_now() const;

  Duration least_delay_;
  ClockFormat format_;
  std::uint32_t last_count_ = 0;
  std::optional<Time> last_received_;
  Time last_stamp_{};
  Duration device_time_{};           ///< unwrapped
  std::deque<LeastOffset> offsets_;  ///< the least of each second, oldest first
};

}  // namespace tandem
