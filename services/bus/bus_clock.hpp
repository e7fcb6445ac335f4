#pragma once

#include <memory>
#include <string>

#include "services/bus/bus.hpp"
#include "services/common/clock.hpp"

namespace tandem::bus {

/// Follows the clock topic: mission time of a simulation or a replay, with its rate and epoch. Before the first clock
/// message, and once none has come for a second of machine time, it stands still: never back to the wall clock.
class BusClock final : public Clock {
 public:
  explicit BusClock(Bus& bus);
  [[nodiscard]] Time now() const override;
  [[nodiscard]] int epoch() const override;
  void wait_until(Time time, const std::function<bool()>& interrupted) override;

 private:
  Bus& bus_;
  Latest<msg::Clock, msg::ClockPubSubType> clock_;
};

/// The clock that `--clock` names: "steady" or "bus".
[[nodiscard]] std::unique_ptr<Clock> make_clock(const std::string& name, Bus& bus);

}  // namespace tandem::bus
