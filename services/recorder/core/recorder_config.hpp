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
  std::vector<std::string> topics;          ///< Only these, as patterns (`*`, `?`); none: all.
  std::vector<std::string> without_topics;  ///< Topics that are not recorded, as patterns.
  bool compact_at_close = true;             ///< Replace the live file by an indexed, compressed one.
  std::int64_t rotate_mb = 1000;            ///< Go on in a new file after so much [MB]; 0: never.
  double rotate_s = 0.0;                    ///< Go on in a new file after so long [s]; 0: never.
  double sync_period_s = 0.5;               ///< What a power failure can cost at most [s].
  double warn_free_share = 0.1;             ///< Warn when less of the disk is free, [0, 1].
  double warn_free_gb = 2.0;                ///< or less than this.
  std::int64_t queue_limit = 10'000;        ///< Messages of one topic kept in memory while the disk is slow,
  std::int64_t queue_limit_mb = 64;         ///< and payload of all topics [MB]. What comes then is dropped and counted.
  double pre_roll_s = 0.0;        ///< Above 0: nothing is recorded until an event, then this time before it, too.
  std::int64_t pre_roll_mb = 64;  ///< Payload kept for that at most [MB].
  double post_roll_s = 60.0;      ///< How long it is recorded after the last event [s].
  /// Topics whose messages are such events, as patterns.
  std::vector<std::string> event_topics{"stop_request", "detection", "human_message", "pose_hint"};

  template <typename Visitor>
  void visit_fields(Visitor& visitor) {
    visitor.field("folder", folder);
    visitor.field("name", name);
    visitor.field("topics", topics);
    visitor.field("without_topics", without_topics);
    visitor.field("compact_at_close", compact_at_close);
    visitor.field("rotate_mb", rotate_mb, Range{0, 1'000'000});
    visitor.field("rotate_s", rotate_s, Range{0.0, 1e6});
    visitor.field("sync_period_s", sync_period_s, Range{0.05, 60.0});
    visitor.field("warn_free_share", warn_free_share, Range{0.0, 1.0});
    visitor.field("warn_free_gb", warn_free_gb, Range{0.0, 1000.0});
    visitor.field("queue_limit", queue_limit, Range{10, 1'000'000});
    visitor.field("queue_limit_mb", queue_limit_mb, Range{1, 100'000});
    visitor.field("pre_roll_s", pre_roll_s, Range{0.0, 3600.0});
    visitor.field("pre_roll_mb", pre_roll_mb, Range{1, 100'000});
    visitor.field("post_roll_s", post_roll_s, Range{0.0, 36000.0});
    visitor.field("event_topics", event_topics);
  }
};

}  // namespace tandem::recorder
