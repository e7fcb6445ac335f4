#include "robot/camera/core/camera_model.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "services/common/random.hpp"

namespace tandem {
namespace {

/// 1 m above the base's middle, looking 45 degrees down.
CameraModel steep_camera() {
  return {.width_px = 201,
          .height_px = 201,
          .focal_px = 100.0,
          .position_in_base = {0.0, 0.0, 1.0},
          .pitch_rad = from_degrees(45.0),
          .yaw_rad = 0.0};
}

TEST(CameraModel, MeetsTheGroundAsFarAheadAsItIsHighAt45Degrees) {
  const auto point = ground_point_of(steep_camera(), {100.0, 100.0});
  ASSERT_TRUE(point);
  EXPECT_NEAR(point->x(), 1.0, 1e-12);
  EXPECT_NEAR(point->y(), 0.0, 1e-12);
}

TEST(CameraModel, ShowsTheLeftOnTheLeftAndTheNearBelow) {
  const CameraModel camera;
  const auto left = pixel_of(camera, {2.0, 0.5, 0.0});
  const auto near = pixel_of(camera, {1.0, 0.0, 0.0});
  const auto far = pixel_of(camera, {3.0, 0.0, 0.0});
  ASSERT_TRUE(left && near && far);
  EXPECT_LT(left->x(), camera.principal_px().x());
  EXPECT_GT(near->y(), far->y());
}

TEST(CameraModel, SeesNoGroundAtTheHorizonAndNothingBehind) {
  const CameraModel camera{.pitch_rad = 0.0};
  EXPECT_FALSE(ground_point_of(camera, camera.principal_px()));
  EXPECT_FALSE(ground_point_of(camera, {0.0, 0.0}));
  EXPECT_TRUE(ground_point_of(camera, {0.0, 239.0}));
  EXPECT_FALSE(pixel_of(camera, {-1.0, 0.0, 0.0}));
}

TEST(CameraModel, FindsAgainWhatItShows) {
  Rng rng{9};
  for (int i = 0; i < 1000; ++i) {
    const CameraModel camera{.pitch_rad = rng.uniform(0.1, 0.8), .yaw_rad = rng.uniform(-1.0, 1.0)};
    const Eigen::Vector2d pixel{rng.uniform(0.0, 319.0), rng.uniform(150.0, 239.0)};
    const auto point = ground_point_of(camera, pixel);
    ASSERT_TRUE(point);
    const auto again = pixel_of(camera, {point->x(), point->y(), 0.0});
    ASSERT_TRUE(again);
    EXPECT_NEAR((*again - pixel).norm(), 0.0, 1e-6);
    EXPECT_TRUE(is_in_picture(camera, *again));
  }
}

TEST(CameraModel, IsLessSureOfWhatIsFar) {
  const CameraModel camera;
  const auto deviation_ahead = [&camera](double distance_m) {
    const auto pixel = pixel_of(camera, {distance_m, 0.0, 0.0});
    return std::sqrt(ground_covariance(camera, *pixel, {})(0, 0));
  };
  EXPECT_LT(deviation_ahead(1.0), 0.03);
  EXPECT_GT(deviation_ahead(4.0), 4.0 * deviation_ahead(1.0));
}

}  // namespace
}  // namespace tandem
