#pragma once

#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "services/bus/bus.hpp"
#include "services/bus/health.hpp"
#include "services/common/site_config.hpp"
#include "services/recorder/arrival_queue.hpp"
#include "services/recorder/core/pre_roll.hpp"
#include "services/recorder/core/recorder_config.hpp"
#include "services/recorder/recording_segment.hpp"

namespace tandem::recorder {

/// The recording a config asks for: `folder`/`name`.mcap, or -2, -3 … where that exists: nothing is ever overwritten.
[[nodiscard]] std::filesystem::path recording_path(const RecorderConfig& config, Time now);

/// Where part `number` (2, 3, …) of the recording `first` goes: robot.mcap, robot_part2.mcap, …; none that exists.
[[nodiscard]] std::filesystem::path part_path(const std::filesystem::path& first, int number);

/// Every file of `config_folder` that ends in .toml, to be attached to a recording.
[[nodiscard]] std::vector<mcap::Attachment> config_attachments(const std::filesystem::path& config_folder, Time now);

/// Writes the topics of the table that the config chooses to a recording: payloads as they came, log time on the bus
/// clock, publish time as the writer stamped it.
///
/// A recording goes on in a new part when one is large or old enough. When the disk is slow, messages are dropped and
/// the drops recorded; when it is full, the recorder stops at the last whole record and says so; the rest goes on.
class RecorderService {
 public:
  /// Throws FileError when `file` cannot be created.
  RecorderService(const RecorderConfig& config, const SiteConfig& site, std::filesystem::path file,
                  std::vector<mcap::Attachment> attachments, bus::Bus& bus);

  /// Waits for something to come (50 ms at most) and writes it.
  void step();
  /// Writes what came and ends the file. Returns what to tell: where it is and what it holds.
  std::string finish();

  [[nodiscard]] std::uint64_t message_count() const { return message_count_; }
  [[nodiscard]] bool is_stopped() const { return !failure_.empty(); }

 private:
  struct Source {
    std::string topic;
    std::string type;
    bool is_state = false;
    bool is_event = false;  ///< its messages start a recording with pre-roll
    std::unique_ptr<bus::Subscription> subscription;
  };

  [[nodiscard]] bool waits_for_events() const { return config_.pre_roll_s > 0.0; }
  void subscribe_to(const std::vector<TopicInfo>& topics);
  void take_arrivals();
  void take(Arrival arrival);
  void write(const Arrival& arrival);
  void write_map_identity(const Arrival& arrival);
  void open_segment();
  void close_segment();
  void end_segment_if_due(Time now);
  void note_drops(Time now);
  void watch_disk();
  void tell_health();
  void fail(const std::string& why);

  RecorderConfig config_;
  SiteConfig site_;
  std::filesystem::path path_;  ///< of the first part
  std::vector<mcap::Attachment> attachments_;
  bus::Bus& bus_;
  bus::HealthReporter health_;
  std::unique_ptr<RecordingSegment> segment_;  ///< none while an event is waited for, and after a failure
  std::unique_ptr<ArrivalQueue> queue_;
  std::vector<Source> sources_;
  PreRoll pre_roll_;
  std::vector<std::future<void>> compactions_;
  int parts_ = 0;
  std::uint64_t message_count_ = 0;
  std::optional<mcap::Metadata> map_;  ///< the map seen last
  std::string failure_;                ///< why nothing more is recorded
  std::string warning_;
  std::uint64_t noted_drops_ = 0;
  Time last_event_{};
  Time next_sync_{};
  Time next_drop_note_{};
  Time next_disk_check_{};
};

}  // namespace tandem::recorder
