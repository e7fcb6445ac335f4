#include "services/relay/link_security.hpp"

#include <chrono>

#include "services/relay/relay_messages.hpp"

namespace tandem {

HostRole role_of(const SiteConfig& site) {
  return site.role == "robot" ? HostRole::Robot : HostRole::Laptop;
}

LinkTopics link_topics(HostRole role) {
  LinkTopics topics;
  for (const auto& info : all_topics()) {
    const std::string name{info.name};
    if (carries(rule_of(info), role, Crossing::HostToLink)) topics.publishes.push_back(name);
    if (carries(rule_of(info), role, Crossing::LinkToHost)) topics.subscribes.push_back(name);
  }
  // Those that relays tell each other.
  for (const auto& name : {topic::kLinkHeartbeat.name, topic::kMapHolding.name, topic::kCompressedMap.name}) {
    topics.publishes.emplace_back(name);
    topics.subscribes.emplace_back(name);
  }
  return topics;
}

security::Expected expected_of(const SiteConfig& site) {
  const LinkTopics topics = link_topics(role_of(site));
  return {site.host, site.robot, static_cast<int>(site.link_domain), topics.publishes, topics.subscribes};
}

std::string security_trouble(const SiteConfig& site, Time now) {
  if (!site.secure_link) return "";
  std::string trouble;
  for (const auto& problem : security::problems_of(security_files_in(site.security_folder), expected_of(site), now)) {
    trouble += (trouble.empty() ? "" : "; ") + problem;
  }
  return trouble;
}

int days_left(const SiteConfig& site, Time now) {
  const Duration left = security::end_of(security_files_in(site.security_folder)) - now;
  return static_cast<int>(std::chrono::floor<std::chrono::days>(left).count());
}

}  // namespace tandem
