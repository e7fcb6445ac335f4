#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "services/bus/bus.hpp"
#include "services/bus/health.hpp"
#include "services/common/site_config.hpp"
#include "services/recorder/core/recorder_config.hpp"
#include "services/recorder/recording_file.hpp"

namespace tandem::recorder {

/// The recording a config asks for: `folder`/`name`.mcap, or -2, -3 … where that exists: nothing is ever overwritten.
[[nodiscard]] std::filesystem::path recording_path(const RecorderConfig& config, Time now);

/// Every file of `config_folder` that ends in .toml, to be attached to a recording.
[[nodiscard]] std::vector<mcap::Attachment> config_attachments(const std::filesystem::path& config_folder, Time now);

/// Writes every topic of the table to one recording: payloads as they came, log time on the bus clock, publish time as
/// the writer stamped it. When the disk is full it stops at the last whole record and says so; the rest goes on.
class RecorderService {
 public:
  /// Throws FileError when `file` cannot be created.
  RecorderService(const RecorderConfig& config, const SiteConfig& site, std::filesystem::path file,
                  const std::vector<mcap::Attachment>& attachments, bus::Bus& bus);

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
    std::shared_ptr<bus::InOrderBox> box;
    std::unique_ptr<bus::Subscription> subscription;
  };

  void write_arrivals();
  void write_sample(const Source& source, const bus::RawSample& sample);
  void write_map_identity(const bus::RawSample& sample);
  void watch_disk();
  [[nodiscard]] std::uint64_t dropped() const;

  RecorderConfig config_;
  std::filesystem::path path_;
  bus::Bus& bus_;
  bus::HealthReporter health_;
  RecordFile file_;
  mcap::LiveWriter writer_;
  mcap::ChannelTable channels_;
  std::vector<Source> sources_;
  std::uint64_t message_count_ = 0;
  std::string known_map_;
  std::string failure_;  ///< why nothing more is recorded
  std::string warning_;
  Time next_sync_{};
  Time next_disk_check_{};
};

}  // namespace tandem::recorder
