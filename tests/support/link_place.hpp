#pragma once

#include <string>
#include <vector>

#include "services/common/site_config.hpp"

namespace tandem::test {

/// Where a host's relay joins the link, and how it looks for the other host.
struct LinkPlace {
  std::string address = "wifi0";  ///< an address, or the interface whose address is followed
  std::string discovery = "auto";
  std::vector<std::string> peers{};
  std::vector<std::string> servers{};
};

/// Writes it down in the host's `site`.
inline void join(SiteConfig& site, const LinkPlace& place) {
  site.link_address = place.address;
  site.discovery = place.discovery;
  site.peers = place.peers;
  site.servers = place.servers;
}

}  // namespace tandem::test
