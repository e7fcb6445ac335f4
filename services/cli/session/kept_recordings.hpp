#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "services/cli/report/episode_reader.hpp"

namespace tandem::cli {

/// A recording and the sessions that ran in it.
struct KeptRecording {
  std::filesystem::path file;
  std::vector<RecordedSession> sessions;
};

/// The recordings in `folder`, by name. What cannot be read is left out, and named on standard error. Throws
/// std::runtime_error when it is no folder, Interrupted on Ctrl-C.
[[nodiscard]] std::vector<KeptRecording> kept_recordings(const std::filesystem::path& folder);

/// Unix time as "2026-11-28T03:00:00Z".
[[nodiscard]] std::string utc_time(std::int64_t stamp_ns);

}  // namespace tandem::cli
