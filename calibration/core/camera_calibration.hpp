#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "calibration/core/camera_residual.hpp"
#include "robot/camera/core/camera_model.hpp"
#include "services/common/pose2.hpp"

namespace tandem {

/// A picture of the board: lying on the ground before the robot, or held by hand. Those on the ground tell where the
/// camera is, the others what its lens is like: a flat ground alone does not tell a pitch from an axis off the middle.
struct BoardView {
  std::optional<Pose2> base_from_board{};  ///< by the tape measure; none for a board that is held
  std::vector<SeenCorner> corners;
};

/// How exactly a board is laid.
struct PlacementDeviation {
  double position_m = 0.002;
  double heading_rad = 0.004;
};

inline constexpr int kCameraParameters = 10;
/// Rows: focal, principal right and down [px], radial; mount x, y, z [m], pitch, yaw, roll [rad].
using CameraCovariance = Eigen::Matrix<double, kCameraParameters, kCameraParameters>;

struct CameraCalibration {
  CameraModel model;
  CameraCovariance covariance = CameraCovariance::Zero();
  double pixel_px = 0.0;                      ///< spread of the corners about the model, along each axis
  std::vector<Eigen::Vector2d> residuals_px;  ///< of all corners, view by view: the model minus the picture
};

/// The lens and the mount that show all boards where they are. `guess` needs only the picture's size right and the rest
/// roughly.
[[nodiscard]] CameraCalibration calibrated_camera(std::span<const BoardView> views, const CameraModel& guess,
                                                  const PlacementDeviation& placement);

/// What the pictures lack, each as a sentence that tells what to do; empty if they calibrate the camera.
[[nodiscard]] std::vector<std::string> missing_views(std::span<const BoardView> views,
                                                     const CameraCalibration* calibration);

}  // namespace tandem
