#pragma once

#include <string>
#include <vector>

#include "services/common/site_config.hpp"
#include "services/relay/core/forwarding.hpp"
#include "services/security/check.hpp"

namespace tandem {

/// Topics that the relay of a host writes and reads on the link.
struct LinkTopics {
  std::vector<std::string> publishes;
  std::vector<std::string> subscribes;
};
[[nodiscard]] LinkTopics link_topics(HostRole role);

[[nodiscard]] HostRole role_of(const SiteConfig& site);

/// What the security files of the host of `site` must fit.
[[nodiscard]] security::Expected expected_of(const SiteConfig& site);

/// Why the secured link of `site` cannot be joined with the files that are there, by the wall clock at `now`; empty if
/// nothing is wrong with them, or the link is not secured.
[[nodiscard]] std::string security_trouble(const SiteConfig& site, Time now);

/// Whole days until the first of the host's certificates and permissions ends. Throws std::runtime_error.
[[nodiscard]] int days_left(const SiteConfig& site, Time now);

}  // namespace tandem
