#include "services/recorder/clock_offsets.hpp"

#include "idl/topics.hpp"
#include "services/bus/codec.hpp"

namespace tandem::recorder {
namespace {

/// What the host of `reader` measured of the clock of `peer`: how far it is ahead.
std::vector<OffsetSample> measured(mcap::Reader& reader, const std::string& peer) {
  std::vector<OffsetSample> samples;
  const mcap::Channel* channel = reader.channel_of(std::string{topic::kLinkStatus.name});
  for (std::size_t i = 0; channel != nullptr && i < reader.message_count(); ++i) {
    if (reader.channel_at(i) != channel->id) continue;
    const auto message = reader.message_at(i);
    if (!message) continue;
    const auto status = bus::decode<msg::LinkStatusPubSubType>({message->data.begin(), message->data.end()});
    const bool is_of_peer = status && status->up() && !status->one_way() && status->peer() == peer;
    if (is_of_peer && status->round_trip_s() > 0.0) samples.push_back({message->log_time, status->clock_offset_s()});
  }
  return samples;
}

}  // namespace

std::string host_of(mcap::Reader& reader) {
  for (const mcap::Metadata& record : reader.metadata()) {
    const auto host = record.entries.find("host");
    if (record.name == "tandem" && host != record.entries.end()) return host->second;
  }
  return "";
}

std::optional<ClockLine> clock_ahead(mcap::Reader& first, mcap::Reader& other) {
  const std::string first_host = host_of(first);
  const std::string other_host = host_of(other);
  if (first_host == other_host) return ClockLine{0.0};
  if (auto by_other = measured(other, first_host); !by_other.empty()) return ClockLine{std::move(by_other)};
  auto by_first = measured(first, other_host);
  if (by_first.empty()) return std::nullopt;
  for (OffsetSample& sample : by_first) {  // to the other's view: its own time, and the sign turned round
    const double ahead_s = sample.offset_s;
    sample.time_ns += static_cast<std::uint64_t>(static_cast<std::int64_t>(ahead_s * 1e9));
    sample.offset_s = -ahead_s;
  }
  return ClockLine{std::move(by_first)};
}

}  // namespace tandem::recorder
