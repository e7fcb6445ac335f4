#include "services/recorder/core/replay_plan.hpp"

#include <algorithm>
#include <array>

namespace tandem::recorder {
namespace {

constexpr std::array<std::string_view, 5> kOfTheMoment{"clock", "service_health", "link_heartbeat", "message_receipt",
                                                       "velocity_command"};
constexpr std::array<std::string_view, 3> kLockstepInputs{"odometry", "scan", "pose_hint"};

template <typename List>
bool has(const List& list, std::string_view topic) {
  return std::find(list.begin(), list.end(), topic) != list.end();
}

}  // namespace

bool is_replayed(std::string_view topic, const ReplayOptions& options) {
  if (!options.topics.empty()) return has(options.topics, topic);
  return options.lockstep ? has(kLockstepInputs, topic) : !has(kOfTheMoment, topic);
}

Time ReplayPace::due(Time logged) const {
  if (rate_ <= 0.0) return start_;
  return start_ + from_seconds(to_seconds(logged - first_) / rate_);
}

Time ReplayPace::mission_time(Time now) const {
  if (is_stopped_) return first_;
  return first_ + from_seconds(to_seconds(now - start_) * rate_);
}

void ReplayPace::stop(Time now) {
  step_to(mission_time(now));
}

void ReplayPace::go_on(Time now) {
  if (!is_stopped_) return;
  start_ = now;
  is_stopped_ = false;
}

void ReplayPace::step_to(Time logged) {
  first_ = logged;
  is_stopped_ = true;
}

}  // namespace tandem::recorder
