#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "services/common/config.hpp"

namespace tandem::recorder {

/// config/<place>/<host>/recorder.toml: where and what to record.
struct RecorderConfig {
  std::string folder = "recordings";        ///< Relative to where the recorder was started.
  std::string name;                         ///< File name without .mcap; empty: date and time of the start (UTC).
  std::vector<std::string> without_topics;  ///< Topics that are not recorded.
  bool compact_at_close = true;             ///< Replace the live file by an indexed, compressed one.
  double sync_period_s = 0.5;               ///< What a power failure can cost at most [s].
  double warn_free_share = 0.1;             ///< Warn when less of the disk is free, [0, 1].
  double warn_free_gb = 2.0;                ///< or less than this.
  std::int64_t queue_limit = 10'000;        ///< Messages of one topic kept in memory while the disk is slow.

  template <typename Visitor>
  void visit_fields(Visitor& visitor) {
    visitor.field("folder", folder);
    visitor.field("name", name);
    visitor.field("without_topics", without_topics);
    visitor.field("compact_at_close", compact_at_close);
    visitor.field("sync_period_s", sync_period_s, Range{0.05, 60.0});
    visitor.field("warn_free_share", warn_free_share, Range{0.0, 1.0});
    visitor.field("warn_free_gb", warn_free_gb, Range{0.0, 1000.0});
    visitor.field("queue_limit", queue_limit, Range{10, 1'000'000});
  }
};

}  // namespace tandem::recorder
