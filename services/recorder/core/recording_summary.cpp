#include "services/recorder/core/recording_summary.hpp"

#include <algorithm>

namespace tandem::recorder {

std::vector<TopicSummary> summary_of(const mcap::Reader& reader) {
  std::map<std::uint16_t, TopicSummary> by_channel;
  for (const auto& [id, channel] : reader.channels()) {
    const auto schema = reader.schemas().find(channel.schema_id);
    by_channel[id] = {channel.topic, schema == reader.schemas().end() ? "" : schema->second.name};
  }
  for (std::size_t i = 0; i < reader.message_count(); ++i) {
    TopicSummary& topic = by_channel[reader.channel_at(i)];
    if (topic.count++ == 0) topic.first_time_ns = reader.log_time_at(i);
    topic.last_time_ns = reader.log_time_at(i);
  }
  std::vector<TopicSummary> all;
  for (auto& [id, topic] : by_channel) {
    const double span_s = static_cast<double>(topic.last_time_ns - topic.first_time_ns) * 1e-9;
    if (span_s > 0.0) topic.rate_hz = static_cast<double>(topic.count - 1) / span_s;
    all.push_back(std::move(topic));
  }
  std::sort(all.begin(), all.end(), [](const TopicSummary& a, const TopicSummary& b) { return a.topic < b.topic; });
  return all;
}

}  // namespace tandem::recorder
