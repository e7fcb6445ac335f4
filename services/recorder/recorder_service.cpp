#include "services/recorder/recorder_service.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <ctime>

#include "services/common/file_io.hpp"
#include "services/common/version.hpp"
#include "services/recorder/core/disposed_record.hpp"
#include "services/recorder/core/schemas.hpp"

namespace tandem::recorder {
namespace {

constexpr Duration kLongestWait = std::chrono::milliseconds{50};
constexpr Duration kDiskCheckPeriod = std::chrono::seconds{5};

std::string date_and_time(Time now) {
  const std::time_t seconds = to_stamp_ns(now) / 1'000'000'000;
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char text[32];
  std::strftime(text, sizeof(text), "%Y-%m-%dT%H-%M-%SZ", &utc);
  return text;
}

}  // namespace

std::filesystem::path recording_path(const RecorderConfig& config, Time now) {
  const std::string name = config.name.empty() ? date_and_time(now) : config.name;
  std::filesystem::path path = std::filesystem::path{config.folder} / (name + ".mcap");
  for (int number = 2; std::filesystem::exists(path); ++number) {
    path = std::filesystem::path{config.folder} / (name + "-" + std::to_string(number) + ".mcap");
  }
  return path;
}

std::vector<mcap::Attachment> config_attachments(const std::filesystem::path& config_folder, Time now) {
  std::vector<mcap::Attachment> attachments;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator{config_folder, ignored}) {
    if (entry.path().extension() != ".toml") continue;
    const auto time = static_cast<std::uint64_t>(to_stamp_ns(now));
    attachments.push_back(
        {time, time, "config/" + entry.path().filename().string(), "application/toml", read_file(entry.path())});
  }
  std::sort(attachments.begin(), attachments.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return attachments;
}

RecorderService::RecorderService(const RecorderConfig& config, const SiteConfig& site, std::filesystem::path file,
                                 const std::vector<mcap::Attachment>& attachments, bus::Bus& bus)
    : config_(config),
      path_(std::move(file)),
      bus_(bus),
      health_(bus, site, "recorder"),
      file_(path_),
      writer_([this](mcap::ByteView record) { return file_.write(record); }, recording_header()),
      channels_(writer_) {
  writer_.write(mcap::Metadata{"tandem",
                               {{"version", version()},
                                {"commit", commit()},
                                {"contract_hash", contract_hash()},
                                {"host", site.host},
                                {"robot", site.robot},
                                {"agent", site.agent}}});
  for (const mcap::Attachment& attachment : attachments) writer_.write(attachment);
  for (const TopicInfo& topic : all_topics()) {
    const std::string name{topic.name};
    const auto& without = config_.without_topics;
    if (std::find(without.begin(), without.end(), name) != without.end()) continue;
    auto box = std::make_shared<bus::InOrderBox>(static_cast<std::size_t>(config_.queue_limit));
    auto subscription = bus_.subscribe(topic, box);
    sources_.push_back({name, topic.make_type()->getName(), std::move(box), std::move(subscription)});
  }
}

void RecorderService::step() {
  bus_.wait(kLongestWait);
  write_arrivals();
  const Time now = bus_.clock().now();
  if (now >= next_sync_ && failure_.empty()) {
    file_.sync();
    next_sync_ = now + from_seconds(config_.sync_period_s);
  }
  if (now >= next_disk_check_) {
    watch_disk();
    next_disk_check_ = now + kDiskCheckPeriod;
  }
  if (!failure_.empty()) {
    health_.step(msg::HEALTH_FAILED, failure_);
  } else if (dropped() > 0) {
    health_.step(msg::HEALTH_DEGRADED, "the disk is too slow: " + std::to_string(dropped()) + " messages not recorded");
  } else {
    health_.step(warning_.empty() ? msg::HEALTH_OK : msg::HEALTH_DEGRADED, warning_);
  }
}

void RecorderService::write_arrivals() {
  struct Arrival {
    const Source* source;
    bus::RawSample sample;
  };
  std::vector<Arrival> arrivals;
  for (const Source& source : sources_) {
    for (bus::RawSample& sample : source.box->take()) arrivals.push_back({&source, std::move(sample)});
  }
  std::stable_sort(arrivals.begin(), arrivals.end(),
                   [](const Arrival& a, const Arrival& b) { return a.sample.received < b.sample.received; });
  for (const Arrival& arrival : arrivals) {
    if (failure_.empty()) write_sample(*arrival.source, arrival.sample);
  }
}

void RecorderService::write_sample(const Source& source, const bus::RawSample& sample) {
  const auto log_time = static_cast<std::uint64_t>(to_stamp_ns(sample.received));
  const auto publish_time = static_cast<std::uint64_t>(to_stamp_ns(sample.source_time));
  bool written = false;
  if (sample.kind == bus::RawSample::Kind::Data) {
    if (source.topic == topic::kMap.name) write_map_identity(sample);
    const std::uint16_t channel = channels_.channel_of(source.topic, source.type, idl_of(source.type));
    written = channels_.write(channel, log_time, publish_time, sample.payload);
  } else if (sample.kind == bus::RawSample::Kind::Disposed) {
    const std::string topic = source.topic + std::string{kDisposedSuffix};
    const std::uint16_t channel = channels_.channel_of(topic, "", "", kDisposedEncoding);
    written = channels_.write(channel, log_time, publish_time, sample.key);
  } else {
    return;  // a writer that ends is no event of the topic
  }
  if (written) {
    ++message_count_;
    return;
  }
  failure_ = "recording stopped after " + std::to_string(message_count_) + " messages: " + file_.error();
  spdlog::error("{}: file={}; free some space and restart the recorder", failure_, path_.string());
}

void RecorderService::write_map_identity(const bus::RawSample& sample) {
  const auto map = bus::decode<msg::OccupancyGridPubSubType>(sample.payload);
  if (!map || map->sha256() == known_map_) return;
  known_map_ = map->sha256();
  writer_.write(mcap::Metadata{"map", {{"map_id", map->map_id()}, {"sha256", map->sha256()}}});
}

void RecorderService::watch_disk() {
  std::error_code error;
  const auto space = std::filesystem::space(path_.parent_path().empty() ? "." : path_.parent_path(), error);
  if (error || space.capacity == 0) return;
  const double free_gb = static_cast<double>(space.available) * 1e-9;
  const double free_share = static_cast<double>(space.available) / static_cast<double>(space.capacity);
  const bool low = free_gb < config_.warn_free_gb || free_share < config_.warn_free_share;
  if (low && warning_.empty()) spdlog::warn("the disk is nearly full: free_gb={:.2f} file={}", free_gb, path_.string());
  warning_ = low ? "the disk is nearly full" : "";
}

std::uint64_t RecorderService::dropped() const {
  std::uint64_t sum = 0;
  for (const Source& source : sources_) sum += source.box->dropped();
  return sum;
}

std::string RecorderService::finish() {
  write_arrivals();
  mcap::Metadata dropped{"dropped", {}};
  for (const Source& source : sources_) {
    if (source.box->dropped() > 0) dropped.entries[source.topic] = std::to_string(source.box->dropped());
  }
  if (!dropped.entries.empty()) writer_.write(dropped);
  const std::string held = path_.string() + ": " + std::to_string(message_count_) + " messages";
  if (!failure_.empty() || !writer_.finish()) return held + "; not complete: " + file_.error();
  file_.sync();
  if (!config_.compact_at_close) return held;
  try {
    compact_recording(path_);
  } catch (const std::exception& error) {
    return held + "; complete, but could not be compressed: " + error.what();
  }
  return held;
}

}  // namespace tandem::recorder
