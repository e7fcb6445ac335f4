#pragma once

#include <optional>
#include <string>
#include <vector>

#include "idl/topics.hpp"
#include "services/common/site_config.hpp"
#include "services/relay/core/forwarding.hpp"
#include "services/relay/core/link_monitor.hpp"

namespace tandem {

[[nodiscard]] ForwardingRule rule_of(const TopicInfo& topic);

/// All topics, those that the robot cannot do without first. Endpoints are announced in the order in which they are
/// made, and on a lossy link the last may be known some seconds after the first.
[[nodiscard]] std::vector<TopicInfo> topics_by_urgency();

/// `role` is that of this host.
[[nodiscard]] msg::LinkHeartbeat to_message(const Heartbeat& heartbeat, const std::string& role);
[[nodiscard]] Heartbeat from_message(const msg::LinkHeartbeat& message);
[[nodiscard]] msg::LinkStatus to_message(const LinkState& state, const std::string& host, Time now);

/// `scan` with every n-th beam, so that at most `most_beams` are left and it fits in one datagram.
[[nodiscard]] msg::LaserScan thinned(const msg::LaserScan& scan, std::size_t most_beams);

/// `map` for the link.
[[nodiscard]] msg::CompressedMap packed(const msg::OccupancyGrid& map);
/// The inverse; none if cells, sizes and hash do not fit together.
[[nodiscard]] std::optional<msg::OccupancyGrid> unpacked(const msg::CompressedMap& map);

}  // namespace tandem
