#include "robot/camera/core/token_finder.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <opencv2/imgproc.hpp>

#include "services/common/random.hpp"
#include "tests/robot/camera/synthetic_picture.hpp"

namespace tandem {
namespace {

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
