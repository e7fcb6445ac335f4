#pragma once

#include <vector>

#include "bench/localization/log_run.hpp"
#include "services/localization/core/trajectory_errors.hpp"

namespace tandem::bench {

/// One robot that did not know where it was.
struct Trial {
  double start_s = 0.0;     ///< when, in the log's time
  double settled_m = -1.0;  ///< driven until the status was first ok; below 0: never
  double right_m = -1.0;    ///< driven until the pose was right and ok, and stayed so to the end; below 0: never
  double flagged_s = -1.0;  ///< kidnapped: time until the status was not ok; below 0: never
  int wrong_ok = 0;         ///< scans with status ok and a wrong pose
  int scans = 0;
  double final_m = 0.0;  ///< error of the last pose
  double final_deg = 0.0;
  double slowest_ms = 0.0;  ///< the longest that nothing was published
  std::string final_status;
};

/// Right: within 0.5 m and 10 degrees of the truth.
[[nodiscard]] bool is_right(const Pose2& estimate, const Pose2& truth);

/// Starts without a start pose, at `count` times spread evenly over the log, each followed for `way_m`.
[[nodiscard]] std::vector<Trial> global_trials(const RecordedLog& log, const LocalizationConfig& config, int count,
                                               double way_m);

/// A robot that knew where it was is carried elsewhere, `count` times, and followed for `way_m` there.
[[nodiscard]] std::vector<Trial> kidnap_trials(const RecordedLog& log, const LocalizationConfig& config, int count,
                                               double way_m);

}  // namespace tandem::bench
