#include "robot/camera/core/token_finder.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <opencv2/imgproc.hpp>

#include "services/common/random.hpp"

namespace tandem {
namespace {

/// What the camera sees of a light grey ground below dark walls, with round tokens at `points` [m, base frame].
cv::Mat picture_of(const CameraConfig& config, const std::vector<Eigen::Vector2d>& points,
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

void add_noise(cv::Mat& picture, Rng& rng, double deviation) {
  for (auto value = picture.begin<cv::Vec3b>(); value != picture.end<cv::Vec3b>(); ++value) {
    for (int channel = 0; channel < 3; ++channel) {
      (*value)[channel] = cv::saturate_cast<uchar>((*value)[channel] + rng.normal(0.0, deviation));
    }
  }
}

TEST(TokenFinder, FindsATokenTwoMetresAheadWithinFiveCentimetres) {
  const CameraConfig config;
  const auto found = find_tokens(picture_of(config, {{2.0, 0.0}}), config);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT((found[0].point_in_base - Eigen::Vector2d{2.0, 0.0}).norm(), 0.05);
}

TEST(TokenFinder, FindsTokensAnywhereOnTheGroundItSeesInANoisyPicture) {
  const CameraConfig config;
  Rng rng{21};
  for (int i = 0; i < 50; ++i) {
    const double ahead = rng.uniform(1.2, 4.0);
    const Eigen::Vector2d point{ahead, rng.uniform(-0.4, 0.4) * (ahead - 0.2)};
    cv::Mat picture = picture_of(config, {point});
    add_noise(picture, rng, 8.0);
    const auto found = find_tokens(picture, config);
    ASSERT_EQ(found.size(), 1u) << "at " << point.transpose();
    const Eigen::Vector2d error = found[0].point_in_base - point;
    EXPECT_LT(error.norm(), 0.03 + 0.02 * ahead * ahead) << "at " << point.transpose();
    EXPECT_LT(error.transpose() * found[0].covariance_in_base.inverse() * error, 14.0) << "at " << point.transpose();
  }
}

TEST(TokenFinder, TakesTokensThatTouchForOnePlace) {
  const CameraConfig config;
  const auto found = find_tokens(picture_of(config, {{2.0, -0.15}, {2.0, 0.0}, {2.0, 0.15}}), config);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT((found[0].point_in_base - Eigen::Vector2d{2.0, 0.0}).norm(), 0.05);
}

TEST(TokenFinder, GivesTheNearestFirst) {
  const CameraConfig config;
  const auto found = find_tokens(picture_of(config, {{3.0, 0.5}, {1.5, -0.3}}), config);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_LT(found[0].point_in_base.x(), found[1].point_in_base.x());
}

TEST(TokenFinder, SeesNothingWhereNothingIsGreenAndRound) {
  const CameraConfig config;
  EXPECT_TRUE(find_tokens(picture_of(config, {}), config).empty());
  EXPECT_TRUE(find_tokens(picture_of(config, {{2.0, 0.0}}, {40, 40, 220}), config).empty());  // red
  cv::Mat lawn(240, 320, CV_8UC3, cv::Scalar(40, 220, 40));
  EXPECT_TRUE(find_tokens(lawn, config).empty());
  cv::Mat poster = picture_of(config, {});
  cv::rectangle(poster, cv::Rect(150, 0, 8, 8), cv::Scalar(40, 220, 40), cv::FILLED);  // above the horizon
  EXPECT_TRUE(find_tokens(poster, config).empty());
}

}  // namespace
}  // namespace tandem
