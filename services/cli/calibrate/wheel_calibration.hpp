#pragma once

#include <functional>
#include <string>
#include <vector>

#include "calibration/core/joint_calibration.hpp"
#include "calibration/core/observability.hpp"

namespace tandem::cli {

struct WheelCalibrationOptions {
  std::string recording;
  std::string output;        ///< folder
  std::string config{};      ///< folder; empty: the built-in values
  std::string model{};       ///< of the robot; empty: as the recording says, or p2at
  bool hold_wheels = false;  ///< look for the laser alone
  bool json = false;
};

/// What was found, and what the services are to read.
struct WheelCalibrationResult {
  std::string recording;
  std::string model;
  bool model_is_known = true;  ///< false: neither the recording nor an option says; p2at was taken
  bool hold_wheels = false;
  DrivenMotion motion;
  JointCalibration calibration;  ///< its wheels are the whole correction, that of the recording included
  std::vector<ParameterKnowledge> known;
  std::vector<std::string> missing;  ///< motion; empty if the calibration is good
  MotionNoise noise;                 ///< of the calibrated wheels, as localization takes it
  std::vector<std::string> files;    ///< that were written
};

/// Reads the recording, calibrates, and writes the report, and the TOML files where the calibration is good. Stops
/// where `keep_going`, which hears the share done, says false. Throws on a recording without odometry or scans.
[[nodiscard]] WheelCalibrationResult run_wheel_calibration(const WheelCalibrationOptions& options,
                                                           const std::function<bool(double, const char*)>& keep_going);

[[nodiscard]] std::string text_of(const WheelCalibrationResult& result);
[[nodiscard]] std::string json_of(const WheelCalibrationResult& result);

}  // namespace tandem::cli
