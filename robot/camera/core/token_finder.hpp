#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>
#include <vector>

#include "robot/camera/core/camera_config.hpp"

namespace tandem {

/// A token in one picture, on the ground.
struct TokenSighting {
  Eigen::Vector2d point_in_base;       ///< [m]
  Eigen::Matrix2d covariance_in_base;  ///< [m2]
  cv::Rect box_px;                     ///< around it in the picture
  int area_px = 0;
};

/// The tokens lying on the ground in `picture` (8-bit BGR, of the config's size), nearest first.
///
/// A token is a spot of the token's colour, no smaller or larger than tokens there look: a few that touch are one spot,
/// and the spot's centre is their place.
[[nodiscard]] std::vector<TokenSighting> find_tokens(const cv::Mat& picture, const CameraConfig& config);

/// How many pixels a token of `radius_m` covers that lies at `point_in_base`.
[[nodiscard]] double area_of_token(const CameraModel& camera, const Eigen::Vector2d& point_in_base, double radius_m);

}  // namespace tandem
