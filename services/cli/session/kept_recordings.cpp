#include "services/cli/session/kept_recordings.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <stdexcept>

#include "services/cli/command.hpp"
#include "services/common/format.hpp"

namespace tandem::cli {

std::vector<KeptRecording> kept_recordings(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder)) {
    throw std::runtime_error(folder.string() + " is no folder: say where recordings are with --folder");
  }
  std::vector<KeptRecording> kept;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".mcap") continue;
    if (stop_requested()) throw Interrupted{};
    try {
      mcap::Reader recording{mcap::file_source(entry.path().string()), entry.path().string()};
      kept.push_back({entry.path(), read_sessions(recording)});
    } catch (const mcap::McapError& error) {
      std::fprintf(stderr, "tandem: left out: %s\n", error.what());
    }
  }
  std::ranges::sort(kept, {}, &KeptRecording::file);
  return kept;
}

std::string utc_time(std::int64_t stamp_ns) {
  const std::time_t seconds = stamp_ns / 1'000'000'000;
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  return formatted("%04d-%02d-%02dT%02d:%02d:%02dZ", parts.tm_year + 1900, parts.tm_mon + 1, parts.tm_mday,
                   parts.tm_hour, parts.tm_min, parts.tm_sec);
}

}  // namespace tandem::cli
