#include "services/relay/core/forwarding.hpp"

namespace tandem {

bool carries(const ForwardingRule& rule, HostRole role, Crossing crossing) {
  const bool outward = crossing == Crossing::HostToLink;
  const bool towards_laptop = outward == (role == HostRole::Robot);
  return towards_laptop ? rule.to_laptop : rule.to_robot;
}

bool ForwardingGate::passes(const Key& key, Time now, double age_s) {
  if (rule_.max_age_s > 0.0 && age_s > rule_.max_age_s) return false;
  if (rule_.max_rate_hz <= 0.0) return true;
  const Duration period = from_seconds(1.0 / rule_.max_rate_hz);
  const auto [entry, is_new] = next_.try_emplace(key, now);
  // A tenth of a period early still counts, else a 10 Hz stream with jitter would be thinned to 5 Hz.
  if (!is_new && now < entry->second - period / 10) return false;
  entry->second = (now - entry->second > period ? now : entry->second) + period;
  return true;
}

}  // namespace tandem
