#include "gateway/server/core/pairing_desk.hpp"

#include <algorithm>
#include <utility>

namespace tandem::gateway {
namespace {

constexpr Duration kMinute = from_seconds(60.0);
constexpr std::size_t kRememberedAddresses = 1000;

}  // namespace

std::string PairingDesk::issue(const Slot& slot, Time now) {
  std::string token = secrets_.new_token();
  tokens_.insert_or_assign(slot.name, Token{secrets_.digest(token), slot, now + rules_.token_life});
  return token;
}

bool PairingDesk::has_token(const std::string& slot, Time now, Duration margin) const {
  const auto found = tokens_.find(slot);
  return found != tokens_.end() && now + margin < found->second.expires;
}

PairingDesk::Outcome PairingDesk::redeem(const std::string& token, const std::string& address, Time now) {
  if (const auto known = failures_.find(address); known != failures_.end() && now < known->second.locked_until) {
    return {std::nullopt, Refusal::Locked};
  }
  const std::string digest = secrets_.digest(token);
  const auto found =
      std::find_if(tokens_.begin(), tokens_.end(), [&](const auto& one) { return one.second.digest == digest; });
  if (found == tokens_.end() || now >= found->second.expires) {
    note_failure(address, now);
    return {std::nullopt, Refusal::WrongToken};
  }
  Paired paired{secrets_.new_session(), found->second.slot};
  tokens_.erase(found);
  std::erase_if(sessions_, [&](const auto& one) {
    const auto& [id, open] = one;
    const bool replaced = paired.slot.exclusive && open.slot.name == paired.slot.name;
    if (replaced) ended_.push_back(id);
    return replaced || now >= open.expires;
  });
  sessions_.emplace(secrets_.digest(paired.session), Open{paired.slot, now + rules_.session_life});
  return {std::move(paired), {}};
}

std::optional<PairingDesk::Session> PairingDesk::session_of(const std::string& secret, Time now) const {
  if (secret.empty()) return std::nullopt;
  const auto found = sessions_.find(secrets_.digest(secret));
  if (found == sessions_.end() || now >= found->second.expires) return std::nullopt;
  return Session{found->first, found->second.slot};
}

std::vector<PairingDesk::Kept> PairingDesk::kept(Time now) const {
  std::vector<Kept> kept;
  for (const auto& [id, open] : sessions_) {
    if (now < open.expires) kept.push_back({id, open.slot.name, open.expires});
  }
  return kept;
}

void PairingDesk::restore(const Kept& session, const Slot& slot) {
  sessions_.insert_or_assign(session.id, Open{slot, session.expires});
}

std::vector<std::string> PairingDesk::take_ended() {
  return std::exchange(ended_, {});
}

void PairingDesk::note_failure(const std::string& address, Time now) {
  if (failures_.size() >= kRememberedAddresses) {
    std::erase_if(failures_, [&](const auto& one) {
      return now >= one.second.locked_until && (one.second.at.empty() || one.second.at.back() + kMinute <= now);
    });
  }
  Failures& failures = failures_[address];
  std::erase_if(failures.at, [&](Time at) { return at + kMinute <= now; });
  failures.at.push_back(now);
  if (static_cast<int>(failures.at.size()) >= rules_.failures_per_minute) {
    failures.locked_until = now + rules_.lock;
    failures.at.clear();
  }
}

}  // namespace tandem::gateway
