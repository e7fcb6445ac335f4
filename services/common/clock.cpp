#include "services/common/clock.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <thread>

namespace tandem {
namespace {

Duration monotonic_now() {
  return std::chrono::steady_clock::now().time_since_epoch();
}

}  // namespace

Time SteadyClock::now() const {
  static const Duration unix_minus_monotonic =
      Duration{std::chrono::system_clock::now().time_since_epoch()} - monotonic_now();
  return Time{monotonic_now() + unix_minus_monotonic};
}

Time wall_time() {
  return Time{std::chrono::system_clock::now().time_since_epoch()};
}

void SteadyClock::wait_until(Time time, const std::function<bool()>& interrupted) {
  constexpr Duration kSlice = std::chrono::milliseconds{50};
  while (!(interrupted && interrupted())) {
    const Duration left = time - now();
    if (left <= Duration::zero()) return;
    std::this_thread::sleep_for(std::min(left, kSlice));
  }
}

Metronome::Metronome(Clock& clock, Duration period) : clock_(clock), period_(period), next_(clock.now() + period) {
  assert(period > Duration::zero());
}

void Metronome::wait(const std::function<bool()>& interrupted) {
  clock_.wait_until(next_, interrupted);
  next_ += period_;
  const Time now = clock_.now();
  if (next_ <= now) next_ = now + period_ - (now - next_) % period_;
}

}  // namespace tandem
