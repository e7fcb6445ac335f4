#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "services/experiment/core/report/episode_log.hpp"
#include "services/recorder/core/mcap_reader.hpp"

namespace tandem::cli {

/// The episodes of a recording: every session that ran in it, in order.
///
/// A press on the phone, a detection and a reminder count once, however often they were repeated on their way. What
/// comes after a session's end and before the next begins belongs to it (the answers of its form); presses before it
/// began, too. `keep_going` hears the share that is read, and ends
/// the reading with false: there are none then.
[[nodiscard]] std::vector<experiment::EpisodeLog> read_episodes(mcap::Reader& recording, const std::string& name,
                                                                const std::function<bool(double)>& keep_going);

/// A session in a recording.
struct RecordedSession {
  std::string code;
  std::string condition;
  std::string agent;
  std::int64_t started_ns = 0;
  double duration_s = 0.0;  ///< 0: its end is not in the recording
  std::string outcome;
};
/// The sessions that ran in a recording, in order; reads nothing else of it.
[[nodiscard]] std::vector<RecordedSession> read_sessions(mcap::Reader& recording);

}  // namespace tandem::cli
