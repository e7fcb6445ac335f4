#pragma once

#include <string>

#include "services/cli/calibrate/wheel_calibration.hpp"

namespace tandem::cli {

/// What was found, as one HTML page that needs no other file: the numbers with how well they are known, the motion that
/// the recording holds, and how wheels and scans differ before and after.
[[nodiscard]] std::string calibration_page(const WheelCalibrationResult& result);

}  // namespace tandem::cli
