#include "robot/safety/core/command_monitor.hpp"

#include <algorithm>
#include <cmath>

namespace tandem::safety {
namespace {

constexpr double kSaneSpeed_mps = 2.0;
constexpr double kSaneTurnRate_radps = 7.0;
constexpr double kRejectionWindow_s = 1.0;

bool is_sane(const Motion& motion) {  // false for NaN
  return std::abs(motion.forward_mps) <= kSaneSpeed_mps && std::abs(motion.turn_rate_radps) <= kSaneTurnRate_radps;
}

}  // namespace

void CommandMonitor::take(const CommandSample& command, Time now) {
  auto known = std::find_if(commanders_.begin(), commanders_.end(),
                            [&](const Commander& one) { return one.heard && one.id == command.commander; });
  if (known == commanders_.end()) {  // takes the place of whoever has been silent for longest
    known = std::min_element(commanders_.begin(), commanders_.end(),
                             [](const Commander& a, const Commander& b) { return a.heard < b.heard; });
    *known = {command.commander, 0, std::nullopt};
  } else if (command.sequence_number <= known->sequence_number) {
    return;  // doubled or overtaken
  }
  known->sequence_number = command.sequence_number;
  known->heard = now;
  if (!is_sane(command.motion)) {
    ++rejected_;
    rejections_[next_rejection_] = now;
    next_rejection_ = (next_rejection_ + 1) % rejections_.size();
    return;
  }
  motion_ = command.motion;
  kind_ = command.kind;
  arrived_ = now;
}

bool CommandMonitor::is_fresh(Time now) const {
  return arrived_ && now - *arrived_ <= from_seconds(config_.command_timeout_s);
}

int CommandMonitor::live_commanders(Time now) const {
  return static_cast<int>(std::count_if(commanders_.begin(), commanders_.end(), [&](const Commander& one) {
    return one.heard && now - *one.heard <= from_seconds(config_.command_timeout_s);
  }));
}

Motion CommandMonitor::wanted(Time now) const {
  return is_fresh(now) ? motion_ : Motion{};
}

Causes CommandMonitor::causes(Time now) const {
  Causes causes;
  // Silence after "stand still", or before the first command, asks for nothing and is no fault.
  causes.set(index_of(Cause::StaleCommand), arrived_ && motion_ != Motion{} && !is_fresh(now));
  causes.set(index_of(Cause::TwoCommanders), live_commanders(now) > 1);
  const auto recent = std::count_if(rejections_.begin(), rejections_.end(), [&](const std::optional<Time>& rejection) {
    return rejection && to_seconds(now - *rejection) <= kRejectionWindow_s;
  });
  causes.set(index_of(Cause::BadCommand), recent > 3);
  return causes;
}

}  // namespace tandem::safety
