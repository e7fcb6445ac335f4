#pragma once

#include <optional>

#include "services/common/time.hpp"
#include "services/localization/core/localization_result.hpp"
#include "services/localization/core/motion_model.hpp"
#include "services/localization/core/odometry_history.hpp"

namespace tandem {

/// A result, and what the wheels said at its time.
struct OdometryResult {
  LocalizationResult result;
  OdometrySample odometry;
};

/// `last` carried on by the wheels to `now`: the covariance grows with the motion, status and agreement stay those of
/// the scan.
///
/// None where the wheels do not tell: in another epoch, before the scan, and longer than `longest` after it, for then
/// the laser has failed and a pose that goes on would hide it.
[[nodiscard]] std::optional<LocalizationResult> predicted(const OdometryResult& last, const OdometrySample& now,
                                                          const MotionNoise& noise, Duration longest);

}  // namespace tandem
