#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "services/bus/bus.hpp"
#include "services/bus/core/service_roster.hpp"
#include "services/common/service_manager.hpp"

namespace tandem::bus {

/// Says once a second, and at once on a change, how a service is: on the bus, and to the service manager, whose watchdog
/// thereby watches the service's loop. Names the peers that do wrong, in the log and as the reason of a degraded state:
/// whoever shares a topic with them, claims the same place, or runs another version beside.
class HealthReporter {
 public:
  HealthReporter(Bus& bus, const SiteConfig& site, std::string service);
  /// To be called some times a second. `elsewhere`: what is wrong in other domains that the service is in.
  void step(msg::HealthState state, const std::string& reason = "", const std::vector<PeerFault>& elsewhere = {});
  /// True while another process says that it is this service of this robot.
  [[nodiscard]] bool is_doubled() const { return doubled_; }

 private:
  void look_around(Time now);
  void log_changes(const std::set<PeerFault>& faults);

  Bus& bus_;
  Writer<msg::ServiceHealth, msg::ServiceHealthPubSubType> writer_;
  InOrder<msg::ServiceHealth, msg::ServiceHealthPubSubType> signs_;
  ServiceRoster roster_;
  ServiceManager manager_;
  msg::ServiceHealth health_;
  std::set<PeerFault> here_;    ///< in the bus's own domain, when we last looked
  std::set<PeerFault> logged_;  ///< and elsewhere
  bool doubled_ = false;
  Time next_{};
  Time next_look_{};
};

/// The sign of a service that says how it is.
[[nodiscard]] ServiceSign sign_of(const msg::ServiceHealth& health);

}  // namespace tandem::bus
