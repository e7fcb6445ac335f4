#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "services/bus/core/service_roster.hpp"

/// What `tandem topics` shows, as values.
namespace tandem::cli {

/// A writer of a topic, and what we heard of it.
struct WriterView {
  std::string host;
  std::string service;
  bool alive = true;            ///< discovery still knows it
  std::uint64_t samples = 0;    ///< heard since we watch
  double rate_hz = 0.0;         ///< of late
  std::optional<double> age_s;  ///< since the last sample; nothing before the first
  std::uint64_t lost = 0;       ///< sequence numbers that never came
  std::uint64_t malformed = 0;  ///< samples that were dropped
  /// [0, 1] of what it sent to us.
  [[nodiscard]] double loss() const {
    const auto sent = samples + malformed + lost;
    return sent == 0 ? 0.0 : static_cast<double>(lost) / static_cast<double>(sent);
  }
};

struct ReaderView {
  std::string host;
  std::string service;
};

/// A topic with everybody on it but ourselves.
struct TopicView {
  std::string topic;
  std::vector<WriterView> writers;  ///< by host and service
  std::vector<ReaderView> readers;
};

struct TopicsView {
  double watched_s = 0.0;
  std::vector<TopicView> topics;
  std::vector<bus::ServiceSign> services;  ///< who says of itself that it runs
  std::vector<bus::PeerFault> faults;      ///< sorted
};

/// The view as a table, a line each, without line ends.
[[nodiscard]] std::vector<std::string> lines_of(const TopicsView& view);

/// The view as JSON, on one line.
[[nodiscard]] std::string json_of(const TopicsView& view);

}  // namespace tandem::cli
