#include "services/bus/event_log.hpp"

namespace tandem::bus {

void SentEvents::sent(const std::string& id, Time now) {
  forget_old(now);
  Entry entry{now, now, {appliers_.begin(), appliers_.end()}, {}};
  if (entry.owing.empty()) entry.outcome.state = EventOutcome::State::Applied;  // nobody answers this topic
  entries_[id] = std::move(entry);
}

bool SentEvents::answered(const std::string& id, const std::string& by, bool applied, const std::string& reason) {
  const auto found = entries_.find(id);
  if (found == entries_.end()) return false;
  Entry& entry = found->second;
  if (entry.outcome.state != EventOutcome::State::Pending) return true;
  if (!applied) {
    entry.outcome = {EventOutcome::State::Refused, by, reason};
    entry.owing.erase(by);
    return true;
  }
  entry.owing.erase(by);
  if (entry.owing.empty()) entry.outcome.state = EventOutcome::State::Applied;
  return true;
}

std::vector<std::string> SentEvents::due(Time now) {
  std::vector<std::string> ids;
  for (auto& [id, entry] : entries_) {
    if (entry.outcome.state != EventOutcome::State::Pending) continue;
    if (now - entry.first_sent >= give_up_after_) {
      entry.outcome = {EventOutcome::State::Undelivered, entry.owing.empty() ? "" : *entry.owing.begin(), "no receipt"};
    } else if (now - entry.last_sent >= repeat_after_) {
      entry.last_sent = now;
      ids.push_back(id);
    }
  }
  return ids;
}

EventOutcome SentEvents::outcome(const std::string& id) const {
  const auto found = entries_.find(id);
  return found == entries_.end() ? EventOutcome{EventOutcome::State::Undelivered, "", "never sent"}
                                 : found->second.outcome;
}

bool SentEvents::is_pending(const std::string& id) const {
  const auto found = entries_.find(id);
  return found != entries_.end() && found->second.outcome.state == EventOutcome::State::Pending;
}

void SentEvents::forget_old(Time now) {
  std::erase_if(entries_, [&](const auto& item) {
    return item.second.outcome.state != EventOutcome::State::Pending &&
           now - item.second.first_sent > 10 * give_up_after_;
  });
}

bool AppliedEvents::is_new(const std::string& id) {
  if (!seen_.try_emplace(id).second) return false;
  order_.push_back(id);
  if (order_.size() > kRemembered) {
    seen_.erase(order_.front());
    order_.pop_front();
  }
  return true;
}

void AppliedEvents::answer(const std::string& id, Answer answer) {
  seen_[id] = std::move(answer);
}

std::optional<AppliedEvents::Answer> AppliedEvents::answer_to(const std::string& id) const {
  const auto found = seen_.find(id);
  return found == seen_.end() ? std::nullopt : found->second;
}

}  // namespace tandem::bus
