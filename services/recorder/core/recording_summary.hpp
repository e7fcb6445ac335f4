#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "services/recorder/core/mcap_reader.hpp"

namespace tandem::recorder {

/// What one topic of a recording holds.
struct TopicSummary {
  std::string topic;
  std::string type;  ///< "tandem::msg::Odometry"; empty where the channel has no schema
  std::uint64_t count = 0;
  double rate_hz = 0.0;             ///< (count - 1) / (last - first); 0 for fewer than two messages
  std::uint64_t first_time_ns = 0;  ///< log time
  std::uint64_t last_time_ns = 0;
};

/// Topics by name, those without a message too.
[[nodiscard]] std::vector<TopicSummary> summary_of(const mcap::Reader& reader);

}  // namespace tandem::recorder
