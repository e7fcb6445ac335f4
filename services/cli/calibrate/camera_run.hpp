#pragma once

#include <string>

#include "services/cli/calibrate/board_pictures.hpp"

namespace tandem::cli {

struct CameraCalibrationOptions {
  std::string pictures;  ///< folder
  std::string ground;    ///< file that says where the board lay
  std::string output;    ///< folder
  std::string config{};  ///< folder with the camera.toml to start from; empty: the built-in values
  std::string board = "8x5";
  double square_m = 0.04;
};

/// Result for people, and whether the camera was calibrated: then camera.toml was written; report.html always is.
struct CameraCalibrationResult {
  std::string text;
  bool good = false;
};
[[nodiscard]] CameraCalibrationResult run_camera_calibration(const CameraCalibrationOptions& options);

}  // namespace tandem::cli
