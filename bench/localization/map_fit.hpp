#pragma once

#include "bench/localization/log_run.hpp"

namespace tandem::bench {

/// How well a run without a known truth explains its scans.
struct MapFit {
  std::size_t scans = 0;      ///< of the log
  std::size_t poses = 0;      ///< given for them
  double ok_share = 0.0;      ///< of the scans
  double first_ok_s = -1.0;   ///< since the first scan; below 0: never
  double near_wall = 0.0;     ///< share of the beams that end within 0.2 m of an occupied cell, over all poses
  double near_wall_ok = 0.0;  ///< ... over those that were ok
  double update_ms = 0.0;     ///< mean
};

[[nodiscard]] MapFit map_fit_of(const RecordedLog& log, const std::vector<RunStep>& steps);

}  // namespace tandem::bench
