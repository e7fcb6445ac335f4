#include "robot/camera/core/camera_model.hpp"

#include <cassert>
#include <cmath>

namespace tandem {
namespace {

/// The camera's axes in the base frame as columns: to the right of the picture, down the picture, along the axis.
Eigen::Matrix3d axes_in_base(const CameraModel& camera) {
  const double cp = std::cos(camera.pitch_rad);
  const double sp = std::sin(camera.pitch_rad);
  const double cy = std::cos(camera.yaw_rad);
  const double sy = std::sin(camera.yaw_rad);
  Eigen::Matrix3d axes;
  const Eigen::Vector3d level{sy, -cy, 0.0};
  const Eigen::Vector3d down{-sp * cy, -sp * sy, -cp};
  axes.col(0) = std::cos(camera.roll_rad) * level + std::sin(camera.roll_rad) * down;
  axes.col(1) = std::cos(camera.roll_rad) * down - std::sin(camera.roll_rad) * level;
  axes.col(2) << cp * cy, cp * sy, -sp;
  return axes;
}

/// The slope that the lens shows at `seen`.
Eigen::Vector2d unbent(const Eigen::Vector2d& seen, double radial) {
  Eigen::Vector2d slope = seen;
  for (int i = 0; i < 20 && radial != 0.0; ++i) slope = seen / (1.0 + radial * slope.squaredNorm());
  return slope;
}

constexpr double kNearest = 1e-3;  ///< [m] along the axis: nothing nearer is seen.

}  // namespace

Eigen::Vector3d ray_in_base(const CameraModel& camera, const Eigen::Vector2d& pixel) {
  const Eigen::Vector2d offset = unbent((pixel - camera.principal_px()) / camera.focal_px, camera.radial);
  return axes_in_base(camera) * Eigen::Vector3d{offset.x(), offset.y(), 1.0};
}

std::optional<Eigen::Vector2d> pixel_of(const CameraModel& camera, const Eigen::Vector3d& point_in_base) {
  const Eigen::Vector3d seen = axes_in_base(camera).transpose() * (point_in_base - camera.position_in_base);
  if (seen.z() < kNearest) return std::nullopt;
  const Eigen::Vector2d slope = seen.head<2>() / seen.z();
  return camera.principal_px() + camera.focal_px * (1.0 + camera.radial * slope.squaredNorm()) * slope;
}

bool is_in_picture(const CameraModel& camera, const Eigen::Vector2d& pixel) {
  return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < camera.width_px - 0.5 &&
         pixel.y() < camera.height_px - 0.5;
}

std::optional<Eigen::Vector2d> ground_point_of(const CameraModel& camera, const Eigen::Vector2d& pixel) {
  const Eigen::Vector3d ray = ray_in_base(camera, pixel);
  if (ray.z() > -1e-6) return std::nullopt;
  const double length = camera.position_in_base.z() / -ray.z();
  return camera.position_in_base.head<2>() + length * ray.head<2>();
}

Eigen::Matrix2d ground_covariance(const CameraModel& camera, const Eigen::Vector2d& pixel, const CameraNoise& noise) {
  const auto here = ground_point_of(camera, pixel);
  assert(here);
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  // Each error that alone would move the point: by differences, one standard deviation towards the robot's feet.
  const auto add = [&](const CameraModel& other_camera, const Eigen::Vector2d& other_pixel) {
    const Eigen::Vector2d moved = *ground_point_of(other_camera, other_pixel) - *here;
    covariance += moved * moved.transpose();
  };
  add(camera, pixel + Eigen::Vector2d{noise.pixel_px, 0.0});
  add(camera, pixel + Eigen::Vector2d{0.0, noise.pixel_px});
  CameraModel nodded = camera;
  nodded.pitch_rad += noise.pitch_rad;
  add(nodded, pixel);
  CameraModel turned = camera;
  turned.yaw_rad += noise.yaw_rad;
  add(turned, pixel);
  return covariance;
}

}  // namespace tandem
