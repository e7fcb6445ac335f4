#include "services/bus/health.hpp"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include "services/common/version.hpp"

namespace tandem::bus {
namespace {

constexpr Duration kPeriod = std::chrono::seconds{1};
constexpr Duration kLookPeriod = std::chrono::milliseconds{250};  // a fault is to be named within two seconds
constexpr std::size_t kMostNamed = 3;                             // in a reason; the log names all
constexpr std::size_t kMostSigns = 1000;

std::string reason_with(std::string reason, const std::set<PeerFault>& faults) {
  std::size_t named = 0;
  for (const auto& fault : faults) {
    if (!reason.empty()) reason += "; ";
    if (named++ == kMostNamed) return reason + "and " + std::to_string(faults.size() - kMostNamed) + " more";
    reason += text_of(fault);
  }
  return reason;
}

const char* name_of(msg::HealthState state) {
  switch (state) {
    case msg::HEALTH_STARTING:
      return "starting";
    case msg::HEALTH_OK:
      return "ok";
    case msg::HEALTH_DEGRADED:
      return "degraded";
    case msg::HEALTH_FAILED:
      return "failed";
  }
  return "unknown";
}

}  // namespace

ServiceSign sign_of(const msg::ServiceHealth& health) {
  return {health.host(),    health.service(),       health.robot(),          health.process_id(),
          health.version(), health.contract_hash(), name_of(health.state()), health.reason()};
}

HealthReporter::HealthReporter(Bus& bus, const SiteConfig& site, std::string service)
    : bus_(bus), writer_(bus.writer(topic::kServiceHealth)), signs_(bus.in_order(topic::kServiceHealth, kMostSigns)) {
  health_.host(site.host);
  health_.robot(site.robot);
  health_.service(std::move(service));
  health_.version(version());
  health_.contract_hash(contract_hash());
  health_.process_id(static_cast<std::uint32_t>(getpid()));
}

void HealthReporter::step(msg::HealthState state, const std::string& reason, const std::vector<PeerFault>& elsewhere) {
  const Time now = bus_.clock().now();
  if (now >= next_look_) look_around(now);
  std::set<PeerFault> faults = here_;
  faults.insert(elsewhere.begin(), elsewhere.end());
  log_changes(faults);
  if (!faults.empty() && state == msg::HEALTH_OK) state = msg::HEALTH_DEGRADED;
  const std::string whole_reason = reason_with(reason, faults);
  const bool works = state == msg::HEALTH_OK || state == msg::HEALTH_DEGRADED;
  manager_.step(works, whole_reason.empty() ? name_of(state) : whole_reason, now);

  const bool changed = state != health_.state() || whole_reason != health_.reason();
  if (now < next_ && !changed) return;
  health_.stamp_ns(to_stamp_ns(now));
  health_.state(state);
  health_.reason(whole_reason);
  writer_.write(health_);
  next_ = now + kPeriod;
}

void HealthReporter::look_around(Time now) {
  next_look_ = now + kLookPeriod;
  for (const auto& sign : signs_.take()) roster_.heard(sign_of(sign.message), sign.received);
  here_.clear();
  for (auto& fault : bus_.peer_faults()) here_.insert(std::move(fault));
  // Other hosts are the relay's concern.
  for (auto& fault : roster_.other_contracts(health_.host(), contract_hash(), now)) here_.insert(std::move(fault));
  const auto twin = roster_.double_of(sign_of(health_), now);
  doubled_ = twin.has_value();
  if (twin) here_.insert(*twin);
}

void HealthReporter::log_changes(const std::set<PeerFault>& faults) {
  for (const auto& fault : faults) {
    if (!logged_.contains(fault)) spdlog::warn("wrong peer: {}", text_of(fault));
  }
  for (const auto& fault : logged_) {
    if (!faults.contains(fault)) spdlog::info("no longer: {}", text_of(fault));
  }
  logged_ = faults;
}

}  // namespace tandem::bus
