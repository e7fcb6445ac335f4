#include "services/bus/core/service_roster.hpp"

#include <algorithm>
#include <array>

#include "services/common/format.hpp"

namespace tandem::bus {
namespace {

/// Of these a robot has one, on whichever host; of all others a host has one.
constexpr std::array<std::string_view, 7> kOnePerRobot{"base",      "laser",   "camera", "localization",
                                                       "navigator", "planner", "tracker"};

bool claim_one_place(const ServiceSign& a, const ServiceSign& b) {
  if (a.service != b.service) return false;
  const bool per_robot = std::find(kOnePerRobot.begin(), kOnePerRobot.end(), a.service) != kOnePerRobot.end();
  return per_robot ? a.robot == b.robot : a.host == b.host;
}

std::string process_text(const ServiceSign& sign) {
  return formatted("process %u on host %s", sign.process_id, sign.host.c_str());
}

PeerFault fault_of(const ServiceSign& a, const ServiceSign& b) {
  const bool bases = a.service == "base";
  const std::string whose = a.robot == b.robot ? a.robot : a.host;
  return {bases ? "X6" : "X5",
          formatted("two %s services for %s: %s, and %s; end one, or rename its robot", a.service.c_str(),
                    whose.c_str(), process_text(a).c_str(), process_text(b).c_str())};
}

}  // namespace

void ServiceRoster::heard(const ServiceSign& sign, Time now) {
  std::erase_if(entries_, [&](const auto& item) { return !is_alive(item.second, now); });
  const Key key{sign.host, sign.service, sign.process_id};
  auto [entry, is_new] = entries_.try_emplace(key, Entry{sign, now, now});
  entry->second.sign = sign;
  entry->second.last = now;
}

std::vector<ServiceSign> ServiceRoster::alive(Time now) const {
  std::vector<ServiceSign> signs;
  for (const auto& [key, entry] : entries_) {
    if (is_alive(entry, now)) signs.push_back(entry.sign);
  }
  return signs;
}

std::vector<std::pair<const ServiceRoster::Entry*, const ServiceRoster::Entry*>> ServiceRoster::pairs(Time now) const {
  std::vector<std::pair<const Entry*, const Entry*>> found;
  for (auto one = entries_.begin(); one != entries_.end(); ++one) {
    for (auto other = std::next(one); other != entries_.end(); ++other) {
      const Entry& a = one->second;
      const Entry& b = other->second;
      const bool at_once = is_alive(a, now) && is_alive(b, now) && a.last > b.first && b.last > a.first;
      if (at_once && claim_one_place(a.sign, b.sign)) found.emplace_back(&a, &b);
    }
  }
  return found;
}

std::vector<PeerFault> ServiceRoster::doubles(Time now) const {
  std::vector<PeerFault> faults;
  for (const auto& [a, b] : pairs(now)) faults.push_back(fault_of(a->sign, b->sign));
  return faults;
}

std::optional<PeerFault> ServiceRoster::double_of(const ServiceSign& self, Time now) const {
  for (const auto& [a, b] : pairs(now)) {
    for (const Entry* entry : {a, b}) {
      const auto& sign = entry->sign;
      if (sign.host == self.host && sign.service == self.service && sign.process_id == self.process_id) {
        return fault_of(a->sign, b->sign);
      }
    }
  }
  return std::nullopt;
}

std::vector<PeerFault> ServiceRoster::other_contracts(std::string_view host, const std::string& contract_hash,
                                                      Time now) const {
  std::vector<PeerFault> faults;
  for (const auto& [key, entry] : entries_) {
    const auto& sign = entry.sign;
    if (!is_alive(entry, now) || sign.contract_hash == contract_hash || (!host.empty() && sign.host != host)) continue;
    faults.push_back(
        other_contract(sign.service + " on host " + sign.host, sign.version, sign.contract_hash, contract_hash));
  }
  return faults;
}

PeerFault other_contract(const std::string& who, const std::string& version, const std::string& contract_hash,
                         const std::string& own_contract_hash) {
  const std::string of_version = version.empty() ? "" : " (" + version + ")";
  return {"X7",
          formatted("%s runs another version%s: its contract is %s, ours %s; install the same release on all hosts",
                    who.c_str(), of_version.c_str(), contract_hash.c_str(), own_contract_hash.c_str())};
}

}  // namespace tandem::bus
