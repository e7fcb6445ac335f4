#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "services/bus/core/peer_fault.hpp"
#include "services/common/time.hpp"

namespace tandem::bus {

/// One running service, as its service_health tells of it.
struct ServiceSign {
  std::string host;
  std::string service;
  std::string robot;
  std::uint32_t process_id = 0;
  std::string version;
  std::string contract_hash;
  std::string state;  ///< for those who show it
  std::string reason;
};

/// Who says that it runs, and who says so twice.
///
/// Two processes that claim one place (the planner of a robot, the relay of a host) count as two only if each was heard
/// after the other had been: one that was started again is one.
class ServiceRoster {
 public:
  /// A service that was silent for longer is gone: it speaks each second.
  static constexpr Duration kSilence = std::chrono::seconds{3};

  void heard(const ServiceSign& sign, Time now);
  /// Services that were heard lately, by host and service.
  [[nodiscard]] std::vector<ServiceSign> alive(Time now) const;
  /// X5 and X6: places that two processes claim at once.
  [[nodiscard]] std::vector<PeerFault> doubles(Time now) const;
  /// The fault that another process claims the place of `self`; none while it is alone.
  [[nodiscard]] std::optional<PeerFault> double_of(const ServiceSign& self, Time now) const;
  /// X7: services on `host` (any, if empty) whose messages are of another contract than `contract_hash`.
  [[nodiscard]] std::vector<PeerFault> other_contracts(std::string_view host, const std::string& contract_hash,
                                                       Time now) const;

 private:
  struct Entry {
    ServiceSign sign;
    Time first{};
    Time last{};
  };
  using Key = std::tuple<std::string, std::string, std::uint32_t>;  // host, service, process
  [[nodiscard]] bool is_alive(const Entry& entry, Time now) const { return now - entry.last <= kSilence; }
  [[nodiscard]] std::vector<std::pair<const Entry*, const Entry*>> pairs(Time now) const;

  std::map<Key, Entry> entries_;
};

/// What two hosts that differ in their contract are told to do.
[[nodiscard]] PeerFault other_contract(const std::string& who, const std::string& version,
                                       const std::string& contract_hash, const std::string& own_contract_hash);

}  // namespace tandem::bus
