#include "services/planner/core/inform/inform_schedule.hpp"

#include <algorithm>

namespace tandem {

std::optional<InformOption> InformSchedule::next(const std::vector<InformOption>& options, Time now) {
  if (under_way_ && to_seconds(now - under_way_->told) < rules_.life_s) return std::nullopt;
  under_way_.reset();
  if (last_told_ && to_seconds(now - *last_told_) < rules_.pause_s) return std::nullopt;
  const InformOption* best = nullptr;
  for (const InformOption& option : options) {
    const auto tried = tries_.find(option.source_id);
    if (option.gain_s <= rules_.cost_s || (tried != tries_.end() && tried->second >= kMostTries)) continue;
    if (best == nullptr || option.gain_s > best->gain_s) best = &option;
  }
  if (best == nullptr) return std::nullopt;
  under_way_ = UnderWay{best->source_id, now};
  last_told_ = now;
  ++tries_[best->source_id];
  return *best;
}

void InformSchedule::heard(const std::string& source_id) {
  forget(source_id);
}

void InformSchedule::forget(const std::string& source_id) {
  if (under_way_ && under_way_->source_id == source_id) under_way_.reset();
  tries_.erase(source_id);
}

}  // namespace tandem
