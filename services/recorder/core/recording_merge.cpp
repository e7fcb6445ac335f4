#include "services/recorder/core/recording_merge.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <string_view>
#include <tuple>
#include <utility>

namespace tandem::recorder {
namespace {

std::uint64_t moved(std::uint64_t time_ns, const ClockLine& clock, std::uint64_t at_ns) {
  const auto offset_ns = static_cast<std::int64_t>(std::llround(clock.offset_s_at(at_ns) * 1e9));
  return static_cast<std::uint64_t>(std::max<std::int64_t>(static_cast<std::int64_t>(time_ns) + offset_ns, 0));
}

/// One message of one recording, by the common clock.
struct Next {
  std::uint64_t log_time = 0;
  std::size_t recording = 0;
  std::size_t index = 0;
};
bool is_later(const Next& a, const Next& b) {
  return std::tie(a.log_time, a.recording, a.index) > std::tie(b.log_time, b.recording, b.index);
}

/// How often each payload of each topic was met in each recording, and how often it was written.
class Doubles {
 public:
  explicit Doubles(std::size_t recordings) : recordings_(recordings) {}
  /// True where this one is written.
  bool is_new(std::uint16_t channel, std::size_t recording, mcap::ByteView payload) {
    const std::string_view text{reinterpret_cast<const char*>(payload.data()), payload.size()};
    Count& count = counts_[{channel, payload.size(), std::hash<std::string_view>{}(text)}];
    count.met.resize(recordings_);
    if (++count.met[recording] <= count.written) return false;
    ++count.written;
    return true;
  }

 private:
  struct Count {
    std::vector<std::uint32_t> met;
    std::uint32_t written = 0;
  };
  std::size_t recordings_;
  std::map<std::tuple<std::uint16_t, std::size_t, std::size_t>, Count> counts_;
};

/// The channels of the merged recording, each topic one.
class MergedChannels {
 public:
  explicit MergedChannels(mcap::Writer& writer) : table_(writer) {}
  std::uint16_t channel_of(const mcap::Reader& reader, std::uint16_t id) {
    const mcap::Channel& channel = reader.channels().at(id);
    const auto schema = reader.schemas().find(channel.schema_id);
    const bool has_schema = schema != reader.schemas().end();
    const std::string name = has_schema ? schema->second.name : "";
    const std::string text = has_schema ? schema->second.text : "";
    const auto [known, is_first] = schemas_.try_emplace(channel.topic, name, text);
    if (!is_first && known->second != std::pair{name, text}) {
      throw mcap::McapError("topic " + channel.topic + " has two different schemas (" + known->second.first + ", " +
                            name + "): recordings of different versions cannot be merged");
    }
    return table_.channel_of(channel.topic, name, text, channel.message_encoding);
  }
  mcap::ChannelTable& table() { return table_; }

 private:
  mcap::ChannelTable table_;
  std::map<std::string, std::pair<std::string, std::string>> schemas_;
};

void write_records_beside(const MergedRecording& recording, mcap::Writer& writer) {
  for (const mcap::Metadata& metadata : recording.reader->metadata()) writer.write(metadata);
  for (mcap::Attachment attachment : recording.reader->attachments()) {
    if (!recording.host.empty()) attachment.name = recording.host + "/" + attachment.name;
    writer.write(attachment);
  }
}

}  // namespace

MergeCount merge(const std::vector<MergedRecording>& recordings, mcap::Writer& writer) {
  std::priority_queue<Next, std::vector<Next>, decltype(&is_later)> queue{&is_later};
  const auto push = [&](std::size_t recording, std::size_t index) {
    const mcap::Reader& reader = *recordings[recording].reader;
    if (index >= reader.message_count()) return;
    const std::uint64_t time = reader.log_time_at(index);
    queue.push({moved(time, recordings[recording].first_clock, time), recording, index});
  };
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    write_records_beside(recordings[i], writer);
    push(i, 0);
  }
  MergedChannels channels{writer};
  Doubles doubles{recordings.size()};
  MergeCount count;
  while (!queue.empty()) {
    const Next next = queue.top();
    queue.pop();
    const MergedRecording& from = recordings[next.recording];
    push(next.recording, next.index + 1);
    const auto message = from.reader->message_at(next.index);
    if (!message) continue;  // damaged; the reader has noted it
    const std::uint16_t channel = channels.channel_of(*from.reader, message->channel_id);
    if (!doubles.is_new(channel, next.recording, message->data)) {
      ++count.doubled;
      continue;
    }
    channels.table().write(channel, next.log_time, moved(message->publish_time, from.first_clock, message->log_time),
                           message->data);
    ++count.written;
  }
  return count;
}

}  // namespace tandem::recorder
