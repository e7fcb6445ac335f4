#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "calibration/core/relative_errors.hpp"

namespace tandem::bench {

/// A log of docs/data.md that is calibrated on its first half and judged on its second.
struct HalvedLog {
  std::string name;
  JointCalibration found{};  ///< on the first half
  RelativeErrors before{};   ///< on the second, as recorded
  RelativeErrors wheels{};   ///< ... with the wheels that were found alone
  RelativeErrors after{};    ///< ... with all that was found
};

/// Calibrates "intel" or "fr079" of `data_folder` by odometry and scans of its first half, and compares the odometry of
/// its second half with the log's reference poses over stretches of `way_m`. Windows in which fr079's wheels are known
/// to slip are left out of the judgement, not of the calibration. Throws where a file is missing.
[[nodiscard]] HalvedLog halved_log(const std::string& name, const std::filesystem::path& data_folder, double way_m);

}  // namespace tandem::bench
