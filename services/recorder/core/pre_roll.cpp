#include "services/recorder/core/pre_roll.hpp"

#include <algorithm>

namespace tandem::recorder {

void PreRoll::keep(Arrival arrival, bool is_state) {
  const Time newest = arrival.received;
  bytes_ += arrival.payload.size();
  recent_.push_back({std::move(arrival), is_state});
  while (!recent_.empty() && (newest - recent_.front().arrival.received > span_ || bytes_ > limit_bytes_)) age_oldest();
}

void PreRoll::age_oldest() {
  Kept oldest = std::move(recent_.front());
  recent_.pop_front();
  bytes_ -= oldest.arrival.payload.size();
  if (!oldest.is_state) return;
  const std::pair instance{oldest.arrival.source, oldest.arrival.key};
  if (oldest.arrival.disposed) {
    states_.erase(instance);
  } else {
    states_.insert_or_assign(instance, std::move(oldest.arrival));
  }
}

std::vector<Arrival> PreRoll::everything() const {
  std::vector<Arrival> all;
  for (const auto& [instance, arrival] : states_) all.push_back(arrival);
  std::stable_sort(all.begin(), all.end(), [](const Arrival& a, const Arrival& b) { return a.received < b.received; });
  for (const Kept& kept : recent_) all.push_back(kept.arrival);
  return all;
}

void PreRoll::settle() {
  while (!recent_.empty()) age_oldest();
}

}  // namespace tandem::recorder
