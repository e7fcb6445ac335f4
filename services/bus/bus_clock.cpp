#include "services/bus/bus_clock.hpp"

#include <algorithm>

namespace tandem::bus {

BusClock::BusClock(Bus& bus) : bus_(bus), clock_(bus.latest(topic::kClock)) {}

Time BusClock::now() const {
  const auto newest = clock_.newest();
  if (!newest) return Time{};
  const Duration since =
      std::clamp<Duration>(bus_.clock().now() - newest->received, Duration::zero(), std::chrono::seconds{1});
  return from_stamp_ns(newest->message.stamp_ns()) + from_seconds(to_seconds(since) * newest->message.rate());
}

int BusClock::epoch() const {
  const auto newest = clock_.newest();
  return newest ? static_cast<int>(newest->message.epoch()) : 0;
}

void BusClock::wait_until(Time time, const std::function<bool()>& interrupted) {
  const int started_in = epoch();
  while (now() < time && epoch() == started_in && !(interrupted && interrupted())) {
    bus_.wait(std::chrono::milliseconds{10});
  }
}

std::unique_ptr<Clock> make_clock(const std::string& name, Bus& bus) {
  if (name == "bus") return std::make_unique<BusClock>(bus);
  return std::make_unique<SteadyClock>();
}

}  // namespace tandem::bus
