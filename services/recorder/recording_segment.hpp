#pragma once

#include <filesystem>
#include <string>

#include "services/recorder/core/arrival.hpp"
#include "services/recorder/recording_file.hpp"

namespace tandem::recorder {

/// One file of a recording while it grows.
class RecordingSegment {
 public:
  /// Creates `file`. Throws FileError.
  RecordingSegment(std::filesystem::path file, Time opened);

  [[nodiscard]] const std::filesystem::path& file() const { return path_; }
  [[nodiscard]] Time opened() const { return opened_; }
  [[nodiscard]] std::uint64_t size_bytes() const { return file_.size_bytes(); }
  [[nodiscard]] std::uint64_t message_count() const { return message_count_; }
  /// Why the last write was false.
  [[nodiscard]] const std::string& error() const { return file_.error(); }

  [[nodiscard]] mcap::Writer& writer() { return writer_; }
  /// Writes what came on `topic`, whose type is `type`. False once the disk is full.
  bool write(const Arrival& arrival, const std::string& topic, const std::string& type);
  void sync() { file_.sync(); }
  /// Ends the file. False where it cannot be ended.
  bool finish();

 private:
  std::filesystem::path path_;
  Time opened_;
  RecordFile file_;
  mcap::LiveWriter writer_;
  mcap::ChannelTable channels_;
  std::uint64_t message_count_ = 0;
};

}  // namespace tandem::recorder
