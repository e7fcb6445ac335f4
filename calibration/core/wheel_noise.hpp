#pragma once

#include <span>

#include "calibration/core/joint_calibration.hpp"
#include "services/localization/core/motion_noise.hpp"

namespace tandem {

/// How wrong the calibrated wheels are, for localization.toml: twice what the residuals show, as other floors are
/// worse, and never less than 2 %. The noise of the scans is in it. drift_m and drift_rad stay as uncalibrated.
[[nodiscard]] MotionNoise wheel_noise(std::span<const PairResidual> residuals);

}  // namespace tandem
