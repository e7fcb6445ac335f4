#pragma once

#include <functional>

#include "services/common/time.hpp"

namespace tandem {

/// Where a shell asks for the time; a core gets a Time handed in.
class Clock {
 public:
  virtual ~Clock() = default;
  /// Mission time now. Never goes back but across a change of epoch() (replay).
  [[nodiscard]] virtual Time now() const = 0;
  /// Counts restarts of time: a stateful service forgets its past when it changes (replay loops, simulation resets).
  [[nodiscard]] virtual int epoch() const { return 0; }
  /// Sleeps until `time` or until `interrupted` says true, whichever is first; asks at least every 50 ms.
  virtual void wait_until(Time time, const std::function<bool()>& interrupted) = 0;
};

/// Unix time when the process first asked one, then the monotonic clock: a step of the wall clock changes nothing, and
/// all clocks of a process agree.
class SteadyClock final : public Clock {
 public:
  [[nodiscard]] Time now() const override;
  void wait_until(Time time, const std::function<bool()>& interrupted) override;
};

/// Unix time by the wall clock, which may step: for what others judge by it, as the validity of certificates.
[[nodiscard]] Time wall_time();

/// Time that stands still until a test moves it.
class ManualClock final : public Clock {
 public:
  explicit ManualClock(Time start = Time{}) : now_(start) {}
  [[nodiscard]] Time now() const override { return now_; }
  void wait_until(Time time, const std::function<bool()>&) override {
    if (time > now_) now_ = time;
  }
  void advance(Duration step) { now_ += step; }

 private:
  Time now_;
};

/// Beats with a fixed period; a beat that was missed is skipped, never caught up.
class Metronome {
 public:
  Metronome(Clock& clock, Duration period);
  /// Sleeps until the next beat, or until `interrupted` says true.
  void wait(const std::function<bool()>& interrupted);

 private:
  Clock& clock_;
  Duration period_;
  Time next_;
};

}  // namespace tandem
