#include "gateway/server/core/state_pacer.hpp"

#include <cmath>

namespace tandem::gateway {
namespace {

/// `state` without what changes all by itself; positions to the centimetre, headings to the degree.
protocol::State essence(protocol::State state) {
  const auto round_to = [](double value, double step) { return std::round(value / step) * step; };
  state.sequence = 0;
  if (state.robot) {
    state.robot->age_s = 0.0;
    state.robot->position = {round_to(state.robot->position.x, 0.01), round_to(state.robot->position.y, 0.01)};
    state.robot->heading = round_to(state.robot->heading, 0.0175);
  }
  for (auto* person : {&state.person, &state.partner}) {
    if (!*person) continue;
    (*person)->age_s = 0.0;
    (*person)->position = {round_to((*person)->position.x, 0.01), round_to((*person)->position.y, 0.01)};
    (*person)->heading = round_to((*person)->heading, 0.0175);
  }
  state.planner.computing_s = 0.0;
  state.planner.progress = 0.0;
  state.link.round_trip_ms = 0.0;
  state.base.battery_v = 0.0;
  state.base.resume_in_s = std::ceil(state.base.resume_in_s);
  return state;
}

}  // namespace

std::optional<protocol::State> StatePacer::next(protocol::State state, Time now) {
  if (last_) {
    const Duration since = now - sent_;
    if (since < least_) return std::nullopt;
    if (since < most_ && essence(state) == essence(*last_)) return std::nullopt;
  }
  state.sequence = last_ ? last_->sequence + 1 : 1;
  sent_ = now;
  last_ = state;
  return state;
}

}  // namespace tandem::gateway
