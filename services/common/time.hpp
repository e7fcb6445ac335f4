#pragma once

#include <chrono>
#include <cstdint>

namespace tandem {

/// Names the time line of a mission; it has no now(): time is handed in. See Clock for who may ask.
struct MissionClock {
  using rep = std::int64_t;
  using period = std::nano;
  using duration = std::chrono::nanoseconds;
  using time_point = std::chrono::time_point<MissionClock, duration>;
};

using Duration = std::chrono::nanoseconds;
/// A point in time, Unix epoch; a wall-clock or steady time_point does not convert to it.
using Time = MissionClock::time_point;

/// `value_s` [s] as a Duration, rounded to the nearest nanosecond.
[[nodiscard]] constexpr Duration from_seconds(double value_s) {
  return Duration{static_cast<std::int64_t>(value_s * 1e9 + (value_s >= 0.0 ? 0.5 : -0.5))};
}

/// `duration` in seconds.
[[nodiscard]] constexpr double to_seconds(Duration duration) {
  return static_cast<double>(duration.count()) * 1e-9;
}

/// Unix time [ns], as stamps travel in messages and files.
[[nodiscard]] constexpr std::int64_t to_stamp_ns(Time time) {
  return time.time_since_epoch().count();
}

/// The inverse of to_stamp_ns.
[[nodiscard]] constexpr Time from_stamp_ns(std::int64_t stamp_ns) {
  return Time{Duration{stamp_ns}};
}

}  // namespace tandem
