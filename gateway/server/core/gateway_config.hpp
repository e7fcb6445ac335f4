#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "services/common/config.hpp"

namespace tandem::gateway {

/// config/<place>/laptop/gateway.toml.
struct GatewayConfig {
  std::string address = "0.0.0.0";       ///< Where to listen: every interface, or one.
  std::int64_t port = 8443;              ///< 0: any free one.
  std::string link_host = "localhost";   ///< Host in the pairing links: this machine's address on the phones' Wi-Fi.
  std::vector<std::string> other_names;  ///< Further names and addresses phones may use.
  std::string state_folder = "/var/lib/tandem/gateway";  ///< Certificate and key.
  std::string participant_link_file;  ///< Always holds a usable pairing link (mode 0600); empty: none is written.
  std::string observer_link_file;
  std::string operator_link_file;
  std::string partner = "";  ///< Code of the second person, of two who search without a robot; empty: there is none.
  std::string partner_link_file;  ///< The link for their phone.
  bool print_qr_code = true;      ///< Shows the participant's link on standard output.
  double state_rate_hz = 10.0;    ///< At most so many states a second go to a phone.
  std::int64_t connections_per_address = 8;
  std::string mode;      ///< human_robot, human_human; empty: as the session says.
  std::string reminder;  ///< Of My pose: none, toast, popup, multimodal, counters; empty: as the session says.
  std::string partner_reminder = "none";  ///< Of the second person, who may be one of the team's own.
  double reminder_threshold_s = 10.0;     ///< Without a pose for so long, the person is reminded.
  double reminder_factor = 0.75;          ///< The next threshold after one that was not obeyed ...
  double reminder_floor_s = 3.0;          ///< ... but not below this.

  template <typename Visitor>
  void visit_fields(Visitor& visitor) {
    visitor.field("address", address);
    visitor.field("port", port, Range{0, 65535});
    visitor.field("link_host", link_host);
    visitor.field("other_names", other_names);
    visitor.field("state_folder", state_folder);
    visitor.field("participant_link_file", participant_link_file);
    visitor.field("observer_link_file", observer_link_file);
    visitor.field("operator_link_file", operator_link_file);
    visitor.field("partner", partner);
    visitor.field("partner_link_file", partner_link_file);
    visitor.field("print_qr_code", print_qr_code);
    visitor.field("state_rate_hz", state_rate_hz, Range{1.0, 20.0});
    visitor.field("connections_per_address", connections_per_address, Range{1, 64});
    visitor.field("mode", mode, {"", "human_robot", "human_human"});
    visitor.field("reminder", reminder, {"", "none", "toast", "popup", "multimodal", "counters"});
    visitor.field("partner_reminder", partner_reminder, {"none", "toast", "popup", "multimodal", "counters"});
    visitor.field("reminder_threshold_s", reminder_threshold_s, Range{1.0, 600.0});
    visitor.field("reminder_factor", reminder_factor, Range{0.1, 1.0});
    visitor.field("reminder_floor_s", reminder_floor_s, Range{1.0, 600.0});
  }
};

}  // namespace tandem::gateway
