#include "robot/camera/core/token_finder.hpp"

#include <algorithm>
#include <numbers>
#include <opencv2/imgproc.hpp>

namespace tandem {
namespace {

constexpr double kLeastOfExpectedArea = 0.2;  // half hidden, or paled by JPEG
constexpr double kMostOfExpectedArea = 6.0;   // several side by side

cv::Scalar colour(std::int64_t hue, std::int64_t saturation, std::int64_t value) {
  return {static_cast<double>(hue), static_cast<double>(saturation), static_cast<double>(value)};
}

}  // namespace

double area_of_token(const CameraModel& camera, const Eigen::Vector2d& point_in_base, double radius_m) {
  const Eigen::Vector3d point{point_in_base.x(), point_in_base.y(), 0.0};
  const Eigen::Vector3d from_camera = point - camera.position_in_base;
  const double distance_m = from_camera.norm();
  const double radius_px = camera.focal_px * radius_m / distance_m;
  const double sine_of_view = -from_camera.z() / distance_m;  // a disc on the ground is seen flattened by so much
  return std::numbers::pi * radius_px * radius_px * sine_of_view;
}

std::vector<TokenSighting> find_tokens(const cv::Mat& picture, const CameraConfig& config) {
  cv::Mat hsv;
  cv::Mat mask;
  cv::Mat labels;
  cv::Mat statistics;
  cv::Mat centres;
  cv::cvtColor(picture, hsv, cv::COLOR_BGR2HSV);
  cv::inRange(hsv, colour(config.hue_min, config.saturation_min, config.value_min), colour(config.hue_max, 255, 255),
              mask);
  const int spots = cv::connectedComponentsWithStats(mask, labels, statistics, centres, 8);

  const CameraModel camera = config.model();
  std::vector<TokenSighting> sightings;
  for (int spot = 1; spot < spots; ++spot) {  // 0 is the background
    const int area_px = statistics.at<int>(spot, cv::CC_STAT_AREA);
    if (area_px < config.area_min_px) continue;
    const Eigen::Vector2d pixel{centres.at<double>(spot, 0), centres.at<double>(spot, 1)};
    const auto point = ground_point_of(camera, pixel);
    if (!point || point->norm() > config.range_max_m) continue;
    const double share = area_px / area_of_token(camera, *point, config.token_radius_m);
    if (share < kLeastOfExpectedArea || share > kMostOfExpectedArea) continue;
    sightings.push_back(
        {.point_in_base = *point,
         .covariance_in_base = ground_covariance(camera, pixel, {}),
         .box_px = {statistics.at<int>(spot, cv::CC_STAT_LEFT), statistics.at<int>(spot, cv::CC_STAT_TOP),
                    statistics.at<int>(spot, cv::CC_STAT_WIDTH), statistics.at<int>(spot, cv::CC_STAT_HEIGHT)},
         .area_px = area_px});
  }
  std::sort(sightings.begin(), sightings.end(), [](const TokenSighting& a, const TokenSighting& b) {
    return a.point_in_base.squaredNorm() < b.point_in_base.squaredNorm();
  });
  return sightings;
}

}  // namespace tandem
