#include "services/cli/teleop/gamepad_state.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tandem::cli {
namespace {

constexpr double kFullScale = 32'767.0;
constexpr double kDeadZone = 0.15;  ///< a stick that nobody touches stands anywhere in it

/// Of a stick that is up or left at -32767: up is ahead and left is counter-clockwise.
double share_of(int value) {
  const double share = -std::clamp(value / kFullScale, -1.0, 1.0);
  const double beyond = std::max(0.0, std::abs(share) - kDeadZone) / (1.0 - kDeadZone);
  return std::copysign(beyond, share);
}

}  // namespace

void GamepadState::take(const js_event& event, Time now) {
  heard_ = now;
  const int type = event.type & ~JS_EVENT_INIT;
  const bool is_first = (event.type & JS_EVENT_INIT) != 0;  // how it stood when it was opened: nobody pressed that
  if (type == JS_EVENT_AXIS && event.number == layout_.forward_axis) forward_ = share_of(event.value);
  if (type == JS_EVENT_AXIS && event.number == layout_.turn_axis) turn_ = share_of(event.value);
  if (type != JS_EVENT_BUTTON || is_first) return;
  if (event.number == layout_.drive_button) driving_ = event.value != 0;
  if (event.number != layout_.resume_button) return;
  if (event.value != 0) {
    resume_since_ = now;
  } else if (const auto since = std::exchange(resume_since_, std::nullopt)) {
    resume_ = to_seconds(now - *since);
  }
}

std::optional<Twist2> GamepadState::wanted(Time now) const {
  if (!driving_) return std::nullopt;
  if (now - heard_ > kSilence) return Twist2{};
  return Twist2{forward_ * speeds_.forward_mps, 0.0, turn_ * speeds_.turn_rate_radps};
}

std::optional<double> GamepadState::take_resume() {
  return std::exchange(resume_, std::nullopt);
}

}  // namespace tandem::cli
