#include "robot/safety/core/stop_state.hpp"

#include <algorithm>

namespace tandem::safety {

void StopState::step(const Causes& holding, Time now, const Causes& excusable) {
  static const Causes kStops = ~causes_with(Resume::AtOnce);
  static const Causes kLatching = causes_with(Resume::Latched);
  excusable_ = excusable;
  excused_ &= holding & excusable;
  holding_ = holding & kStops & ~excused_;
  latched_ |= holding_ & kLatching;
  if (holding_.any()) {
    stopped_ = true;
    free_at_.reset();
  } else if (stopped_ && latched_.none() && !free_at_) {
    free_at_ = now + from_seconds(config_.healthy_s + config_.warning_s);
  }
}

std::string_view StopState::resume(double held_s, Time now) {
  // Commands that ceased are no danger to resume from: nothing moves before new ones come.
  Causes still_holding = holding_ & ~excusable_;
  still_holding.reset(index_of(Cause::StaleCommand));
  if (!(held_s >= config_.resume_hold_s)) return "hold the button longer";
  for (const StopRule& rule : kStopRules) {
    if (still_holding.test(index_of(rule.cause))) return rule.message;
  }
  if (latched_.none()) return "nothing to resume";
  latched_.reset();
  excused_ |= holding_ & excusable_;
  holding_ &= ~excused_;
  if (holding_.none()) free_at_ = now + from_seconds(config_.warning_s);
  return {};
}

bool StopState::may_move(Time now) const {
  return holding_.none() && latched_.none() && (!stopped_ || now >= free_at_.value_or(Time::max()));
}

double StopState::resume_in_s(Time now) const {
  return free_at_ ? std::max(0.0, to_seconds(*free_at_ - now)) : 0.0;
}

}  // namespace tandem::safety
