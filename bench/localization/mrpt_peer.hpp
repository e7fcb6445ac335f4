#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "bench/localization/recorded_log.hpp"

namespace tandem::bench {

/// What MRPT's `pf-localization` made of a log.
struct PeerRun {
  std::vector<TimedPose> poses;  ///< one per scan
  double update_ms = 0.0;        ///< CPU time of the whole program per scan
};

/// Is `pf-localization` on this machine (Debian `mrpt-apps`)?
[[nodiscard]] bool has_mrpt();

/// Runs it over `log` with `particles` particles, from where the truth begins.
///
/// Scans and odometry go through a CARMEN log and `carmen2rawlog`, the map through `ros-map-yaml2mrpt`; all files stay
/// in `folder`. Throws if a program fails.
[[nodiscard]] PeerRun run_mrpt(const RecordedLog& log, std::size_t particles, const std::filesystem::path& folder);

}  // namespace tandem::bench
