#pragma once

#include <Eigen/Core>
#include <optional>

#include "services/common/angle.hpp"

namespace tandem {

/// A camera fixed on the robot, pitched down. Its lens may bend straight lines towards or from the picture's middle.
///
/// The base frame lies on the ground: x ahead, y left, z up. A pixel is (u to the right, v down) with (0, 0) the centre
/// of the picture's first pixel. Defaults: the simulated robot's camera, 60 degrees wide.
struct CameraModel {
  int width_px = 320;
  int height_px = 240;
  double focal_px = 277.0;                            ///< The same along both axes.
  Eigen::Vector3d position_in_base{0.20, 0.0, 0.60};  ///< [m]
  double pitch_rad = from_degrees(20.0);              ///< Downwards from level.
  double yaw_rad = 0.0;                               ///< To the left of straight ahead.

  double roll_rad = 0.0;                          ///< The camera turned clockwise about its axis.
  Eigen::Vector2d principal_offset_px{0.0, 0.0};  ///< Where the axis meets the picture, from its middle.
  double radial = 0.0;                            ///< A point at slope r from the axis is seen at r (1 + radial r^2).

  /// Where the axis meets the picture.
  [[nodiscard]] Eigen::Vector2d principal_px() const {
    return Eigen::Vector2d{(width_px - 1) / 2.0, (height_px - 1) / 2.0} + principal_offset_px;
  }
};

/// The direction, in the base frame and not of unit length, in which `pixel` looks.
[[nodiscard]] Eigen::Vector3d ray_in_base(const CameraModel& camera, const Eigen::Vector2d& pixel);

/// The pixel that shows `point_in_base` [m]; none if it lies behind the camera. It may lie outside the picture.
[[nodiscard]] std::optional<Eigen::Vector2d> pixel_of(const CameraModel& camera, const Eigen::Vector3d& point_in_base);

/// True if `pixel` lies in the picture.
[[nodiscard]] bool is_in_picture(const CameraModel& camera, const Eigen::Vector2d& pixel);

/// The point of the ground [m, base frame] that `pixel` shows; none at or above the horizon.
[[nodiscard]] std::optional<Eigen::Vector2d> ground_point_of(const CameraModel& camera, const Eigen::Vector2d& pixel);

/// How well a camera knows where it looks.
struct CameraNoise {
  double pixel_px = 1.0;                 ///< Standard deviation of a pixel found in the picture, along each axis.
  double pitch_rad = from_degrees(0.5);  ///< ... of the mount's pitch: floors are not flat, robots nod.
  double yaw_rad = from_degrees(0.5);    ///< ... of the mount's yaw.
};

/// Covariance [m2] of ground_point_of(camera, pixel): to first order, it grows with the fourth power of the distance
/// along the ray. The pixel must show ground.
[[nodiscard]] Eigen::Matrix2d ground_covariance(const CameraModel& camera, const Eigen::Vector2d& pixel,
                                                const CameraNoise& noise);

}  // namespace tandem
