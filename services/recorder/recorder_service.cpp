#include "services/recorder/recorder_service.hpp"

#include <spdlog/spdlog.h>
#include <sys/resource.h>

#include <algorithm>
#include <ctime>
#include <numeric>

#include "services/common/file_io.hpp"
#include "services/common/version.hpp"
#include "services/recorder/core/topic_choice.hpp"

namespace tandem::recorder {
namespace {

constexpr Duration kLongestWait = std::chrono::milliseconds{50};
constexpr Duration kDiskCheckPeriod = std::chrono::seconds{5};
constexpr Duration kDropNotePeriod = std::chrono::seconds{1};
constexpr std::uint64_t kMegabyte = 1'000'000;
constexpr int kCompactionNiceness = 10;  ///< it can wait, what is being recorded cannot

std::size_t bytes_of_mb(std::int64_t megabytes) {
  return static_cast<std::size_t>(megabytes) * kMegabyte;
}

/// `folder`/`stem`.mcap, or `stem`-2.mcap, -3 … where that exists.
std::filesystem::path free_path(const std::filesystem::path& folder, const std::string& stem) {
  std::filesystem::path path = folder / (stem + ".mcap");
  for (int number = 2; std::filesystem::exists(path); ++number) {
    path = folder / (stem + "-" + std::to_string(number) + ".mcap");
  }
  return path;
}

void compact_beside(const std::filesystem::path& file) {
  setpriority(PRIO_PROCESS, 0, kCompactionNiceness);  // of this thread alone
  try {
    compact_recording(file);
  } catch (const std::exception& error) {
    spdlog::warn("a recording is whole, but could not be compressed: {}", error.what());
  }
}

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
  return free_path(config.folder, config.name.empty() ? date_and_time(now) : config.name);
}

std::filesystem::path part_path(const std::filesystem::path& first, int number) {
  return free_path(first.parent_path(), first.stem().string() + "_part" + std::to_string(number));
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
                                 std::vector<mcap::Attachment> attachments, bus::Bus& bus)
    : config_(config),
      site_(site),
      path_(std::move(file)),
      attachments_(std::move(attachments)),
      bus_(bus),
      health_(bus, site, "recorder"),
      pre_roll_(from_seconds(config.pre_roll_s), bytes_of_mb(config.pre_roll_mb)) {
  if (!waits_for_events()) open_segment();
  std::vector<TopicInfo> topics;
  for (const TopicInfo& topic : all_topics()) {
    if (is_chosen(topic.name, config_.topics, config_.without_topics)) topics.push_back(topic);
  }
  subscribe_to(topics);
}

void RecorderService::subscribe_to(const std::vector<TopicInfo>& topics) {
  queue_ = std::make_unique<ArrivalQueue>(topics.size(), static_cast<std::size_t>(config_.queue_limit),
                                          bytes_of_mb(config_.queue_limit_mb));
  for (const TopicInfo& topic : topics) {
    const bool is_state = topic.delivery == Delivery::State || topic.delivery == Delivery::Bulk;
    const bool is_event = !config_.event_topics.empty() && is_chosen(topic.name, config_.event_topics, {});
    auto subscription = bus_.subscribe(topic, std::make_shared<ArrivalBox>(*queue_, sources_.size()));
    sources_.push_back(
        {std::string{topic.name}, topic.make_type()->getName(), is_state, is_event, std::move(subscription)});
  }
}

void RecorderService::open_segment() {
  ++parts_;
  segment_ = std::make_unique<RecordingSegment>(parts_ == 1 ? path_ : part_path(path_, parts_), bus_.clock().now());
  segment_->writer().write(mcap::Metadata{"tandem",
                                          {{"version", version()},
                                           {"commit", commit()},
                                           {"contract_hash", contract_hash()},
                                           {"host", site_.host},
                                           {"robot", site_.robot},
                                           {"agent", site_.agent},
                                           {"part", std::to_string(parts_)}}});
  for (const mcap::Attachment& attachment : attachments_) segment_->writer().write(attachment);
  if (map_) segment_->writer().write(*map_);
}

void RecorderService::close_segment() {
  if (!segment_->finish()) {
    fail(segment_->error());
    return;
  }
  const std::filesystem::path file = segment_->file();
  segment_.reset();
  pre_roll_.settle();
  if (config_.compact_at_close) compactions_.push_back(std::async(std::launch::async, compact_beside, file));
}

void RecorderService::end_segment_if_due(Time now) {
  if (!segment_) return;
  const bool is_large = config_.rotate_mb > 0 && segment_->size_bytes() >= bytes_of_mb(config_.rotate_mb);
  const bool is_old = config_.rotate_s > 0.0 && now - segment_->opened() >= from_seconds(config_.rotate_s);
  const bool is_over = waits_for_events() && now - last_event_ >= from_seconds(config_.post_roll_s);
  if (!is_large && !is_old && !is_over) return;
  close_segment();
  if (is_over || !failure_.empty()) return;
  try {
    open_segment();
  } catch (const FileError& error) {
    fail(error.what());
  }
}

void RecorderService::step() {
  bus_.wait(kLongestWait);
  take_arrivals();
  const Time now = bus_.clock().now();
  if (now >= next_sync_ && segment_) {
    segment_->sync();
    next_sync_ = now + from_seconds(config_.sync_period_s);
  }
  end_segment_if_due(now);
  note_drops(now);
  if (now >= next_disk_check_) {
    watch_disk();
    next_disk_check_ = now + kDiskCheckPeriod;
  }
  tell_health();
}

void RecorderService::tell_health() {
  if (!failure_.empty()) {
    health_.step(msg::HEALTH_FAILED, failure_);
  } else if (noted_drops_ > 0) {
    health_.step(msg::HEALTH_DEGRADED,
                 "the disk is too slow: " + std::to_string(noted_drops_) + " messages not recorded");
  } else {
    health_.step(warning_.empty() ? msg::HEALTH_OK : msg::HEALTH_DEGRADED, warning_);
  }
}

void RecorderService::take_arrivals() {
  for (Arrival& arrival : queue_->take()) {
    if (failure_.empty()) take(std::move(arrival));
  }
}

void RecorderService::take(Arrival arrival) {
  const Source& source = sources_[arrival.source];
  if (source.topic == topic::kMap.name) write_map_identity(arrival);
  if (!waits_for_events()) {
    write(arrival);
    return;
  }
  if (source.is_event) last_event_ = arrival.received;
  if (segment_) write(arrival);
  pre_roll_.keep(std::move(arrival), source.is_state);
  if (segment_ || !source.is_event) return;
  try {
    open_segment();
  } catch (const FileError& error) {
    fail(error.what());
    return;
  }
  spdlog::info("an event is recorded: topic={} file={}", source.topic, segment_->file().string());
  for (const Arrival& before : pre_roll_.everything()) {
    if (segment_) write(before);
  }
}

void RecorderService::write(const Arrival& arrival) {
  if (segment_->write(arrival, sources_[arrival.source].topic, sources_[arrival.source].type)) {
    ++message_count_;
    end_segment_if_due(arrival.received);
  } else {
    fail(segment_->error());
  }
}

void RecorderService::fail(const std::string& why) {
  failure_ = "recording stopped after " + std::to_string(message_count_) + " messages: " + why;
  segment_.reset();
  spdlog::error("{}: file={}; free some space and restart the recorder", failure_, path_.string());
}

void RecorderService::write_map_identity(const Arrival& arrival) {
  const auto map = bus::decode<msg::OccupancyGridPubSubType>(arrival.payload);
  if (!map || (map_ && map_->entries.at("sha256") == map->sha256())) return;
  map_ = mcap::Metadata{"map", {{"map_id", map->map_id()}, {"sha256", map->sha256()}}};
  if (segment_) segment_->writer().write(*map_);
}

void RecorderService::note_drops(Time now) {
  const std::vector<std::uint64_t> dropped = queue_->dropped();
  const std::uint64_t sum = std::accumulate(dropped.begin(), dropped.end(), std::uint64_t{0});
  if (sum == noted_drops_ || now < next_drop_note_) return;
  next_drop_note_ = now + kDropNotePeriod;
  noted_drops_ = sum;
  mcap::Metadata note{"dropped", {{"until_ns", std::to_string(to_stamp_ns(now))}}};
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    if (dropped[i] > 0) note.entries[sources_[i].topic] = std::to_string(dropped[i]);
  }
  if (segment_) segment_->writer().write(note);
  spdlog::warn("the disk is too slow: dropped={} file={}", sum, path_.string());
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

std::string RecorderService::finish() {
  take_arrivals();
  next_drop_note_ = {};
  note_drops(bus_.clock().now());
  if (segment_) close_segment();
  for (const std::future<void>& compaction : compactions_) compaction.wait();
  if (parts_ == 0 && failure_.empty()) return "nothing was recorded: no event came";
  const std::string more = parts_ > 1 ? " and " + std::to_string(parts_ - 1) + " more parts" : "";
  const std::string held = path_.string() + more + ": " + std::to_string(message_count_) + " messages";
  return failure_.empty() ? held : held + "; not complete: " + failure_;
}

}  // namespace tandem::recorder
