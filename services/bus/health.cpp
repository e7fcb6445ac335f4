#include "services/bus/health.hpp"

#include <unistd.h>

#include "services/common/version.hpp"

namespace tandem::bus {

HealthReporter::HealthReporter(Bus& bus, const SiteConfig& site, std::string service)
    : bus_(bus), writer_(bus.writer(topic::kServiceHealth)) {
  health_.host(site.host);
  health_.robot(site.robot);
  health_.service(std::move(service));
  health_.version(version());
  health_.contract_hash(contract_hash());
  health_.process_id(static_cast<std::uint32_t>(getpid()));
}

void HealthReporter::step(msg::HealthState state, const std::string& reason) {
  const Time now = bus_.clock().now();
  const bool changed = state != health_.state() || reason != health_.reason();
  if (now < next_ && !changed) return;
  health_.stamp_ns(to_stamp_ns(now));
  health_.state(state);
  health_.reason(reason);
  writer_.write(health_);
  next_ = now + std::chrono::seconds{1};
}

}  // namespace tandem::bus
