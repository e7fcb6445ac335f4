#pragma once

#include "services/common/config.hpp"

namespace tandem {

/// config/<place>/<host>/relay.toml.
struct RelayConfig {
  double heartbeat_period_s = 0.1;
  double heartbeat_timeout_s = 1.5;  ///< The link counts as lost when no heartbeat came for so long.
  std::int64_t scan_beams = 180;     ///< Most beams of a relayed scan, so that it fits in one datagram.
  double map_patience_s = 5.0;       ///< A host without a map asks for one after so long.
  double bulk_rate_bps = 1.6e6;      ///< Bits per second that States may take: less than the link carries.

  template <typename Visitor>
  void visit_fields(Visitor& visitor) {
    visitor.field("heartbeat_period_s", heartbeat_period_s, Range{0.02, 1.0});
    visitor.field("heartbeat_timeout_s", heartbeat_timeout_s, Range{0.2, 30.0});
    visitor.field("scan_beams", scan_beams, Range{16, 300});
    visitor.field("map_patience_s", map_patience_s, Range{0.0, 600.0});
    visitor.field("bulk_rate_bps", bulk_rate_bps, Range{1e5, 1e9});
  }
};

}  // namespace tandem
