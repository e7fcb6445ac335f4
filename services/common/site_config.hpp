#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "services/common/config.hpp"

namespace tandem {

/// config/<place>/site.toml: what all services of one host share.
struct SiteConfig {
  std::string host = "robot1";    ///< This host's name, unique on the link.
  std::string role = "robot";     ///< "robot", "laptop", or "both" when everything runs on one host.
  std::string robot = "robot1";   ///< The robot of this team; on a robot host, its own name.
  std::string agent = "person1";  ///< The person of this team, a code, never a name.
  std::int64_t host_domain = 10;  ///< DDS domain of this host's services, bound to 127.0.0.1.
  std::int64_t link_domain = 20;  ///< DDS domain between the relays.
  /// Interface the relay uses (Wi-Fi, WireGuard), whose address it follows: "wlan0"; or one address.
  std::string link_address = "127.0.0.1";
  std::string discovery = "auto";    ///< How relays find each other on the link.
  std::vector<std::string> peers;    ///< Addresses of the other relays, for "peers" and "auto".
  std::vector<std::string> servers;  ///< Addresses of the relays that keep the list for all, for "server".
  /// Only hosts with a certificate of the lab's authority take part in the link, and all on it is encrypted.
  bool secure_link = false;
  /// Where this host's certificate and the rest of SecurityFiles are, for secure_link.
  std::string security_folder = "/etc/tandem/security";

  /// What the robot does without a link: stand still; go on to the end of its path; or back to where it had one. The
  /// safety gate says how far (last_leg_m in base.toml).
  std::string on_link_loss = "stop";

  template <typename Visitor>
  void visit_fields(Visitor& visitor) {
    visitor.field("host", host);
    visitor.field("role", role, {"robot", "laptop", "both"});
    visitor.field("robot", robot);
    visitor.field("agent", agent);
    visitor.field("host_domain", host_domain, Range{0, 101});
    visitor.field("link_domain", link_domain, Range{0, 101});
    visitor.field("link_address", link_address);
    visitor.field("discovery", discovery, {"auto", "multicast", "peers", "server"});
    visitor.field("peers", peers);
    visitor.field("servers", servers);
    visitor.field("secure_link", secure_link);
    visitor.field("security_folder", security_folder);
    visitor.field("on_link_loss", on_link_loss, {"stop", "finish_leg", "retreat"});
  }
};

}  // namespace tandem
