#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "robot/camera/core/camera_config.hpp"

namespace tandem {

/// What the camera sees of a light grey ground below dark walls, with round tokens at `points` [m, base frame].
inline cv::Mat picture_of(const CameraConfig& config, const std::vector<Eigen::Vector2d>& points,
                          const cv::Scalar& colour_bgr = {40, 220, 40}) {
  const CameraModel camera = config.model();
  cv::Mat picture(camera.height_px, camera.width_px, CV_8UC3, cv::Scalar(60, 60, 60));
  for (int v = 0; v < picture.rows; ++v) {
    if (ground_point_of(camera, {0.0, v})) picture.row(v).setTo(cv::Scalar(200, 200, 200));
  }
  for (const Eigen::Vector2d& centre : points) {
    std::vector<cv::Point> outline;
    constexpr int kShift = 4;  // fillPoly's fractions of a pixel: 1/16
    for (int i = 0; i < 64; ++i) {
      const double angle = i * 2.0 * std::numbers::pi / 64;
      const Eigen::Vector3d edge{centre.x() + config.token_radius_m * std::cos(angle),
                                 centre.y() + config.token_radius_m * std::sin(angle), 0.0};
      if (const auto pixel = pixel_of(camera, edge)) {
        outline.emplace_back(cvRound(pixel->x() * (1 << kShift)), cvRound(pixel->y() * (1 << kShift)));
      }
    }
    cv::fillPoly(picture, std::vector<std::vector<cv::Point>>{outline}, colour_bgr, cv::LINE_8, kShift);
  }
  return picture;
}

}  // namespace tandem
