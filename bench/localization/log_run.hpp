#pragma once

#include <vector>

#include "bench/localization/recorded_log.hpp"
#include "services/localization/core/localizer.hpp"

namespace tandem::bench {

/// A pose that the localizer gave, and what it cost.
struct RunStep {
  LocalizationResult result;
  double update_ms = 0.0;   ///< thread CPU time since the pose before
  double longest_ms = 0.0;  ///< ... of the longest piece of it: for so long nothing is published
};

/// Which part of a log is run, and how.
struct RunOptions {
  LocalizationConfig config;
  Time from{Duration::min()};
  Time until{Duration::max()};
};

/// Feeds the log to a new localizer in its order.
[[nodiscard]] std::vector<RunStep> run_log(const RecordedLog& log, const RunOptions& options);

}  // namespace tandem::bench
