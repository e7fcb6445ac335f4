#pragma once

#include <string>

#include "services/bus/bus.hpp"

namespace tandem::bus {

/// Says once a second, and at once on a change, how a service is.
class HealthReporter {
 public:
  HealthReporter(Bus& bus, const SiteConfig& site, std::string service);
  void step(msg::HealthState state, const std::string& reason = "");

 private:
  Bus& bus_;
  Writer<msg::ServiceHealth, msg::ServiceHealthPubSubType> writer_;
  msg::ServiceHealth health_;
  Time next_{};
};

}  // namespace tandem::bus
