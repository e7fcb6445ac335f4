#include "robot/camera/core/place_confirmation.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tandem {
namespace {

const Time kStart = from_stamp_ns(1'000'000'000'000);
constexpr Duration kFrame = std::chrono::milliseconds{200};

UncertainPoint point(double x, double y) {
  return {{x, y}, Eigen::Matrix2d::Identity() * 0.01};
}

TEST(PlaceConfirmation, NeedsSightingsInThreePicturesAndSpeaksOnce) {
  PlaceConfirmation places{3, 0.5};
  EXPECT_FALSE(places.add(point(5.0, 5.0), kStart));
  EXPECT_FALSE(places.add(point(5.3, 5.0), kStart + kFrame));
  const auto confirmed = places.add(point(5.0, 5.3), kStart + 2 * kFrame);
  ASSERT_TRUE(confirmed);
  EXPECT_EQ(confirmed->frames, 3);
  EXPECT_NEAR(confirmed->point_in_map.position.x(), 5.1, 1e-6);  // equally sure: their mean
  EXPECT_NEAR(confirmed->point_in_map.position.y(), 5.1, 1e-6);
  for (int i = 3; i < 20; ++i) EXPECT_FALSE(places.add(point(5.1, 5.1), kStart + i * kFrame));
}

TEST(PlaceConfirmation, CountsSeveralTokensInOnePictureOnce) {
  PlaceConfirmation places{3, 0.5};
  for (int i = 0; i < 5; ++i) EXPECT_FALSE(places.add(point(5.0 + 0.1 * i, 5.0), kStart));
}

TEST(PlaceConfirmation, KeepsPlacesApart) {
  PlaceConfirmation places{2, 0.5};
  EXPECT_FALSE(places.add(point(0.0, 0.0), kStart));
  EXPECT_FALSE(places.add(point(1.0, 0.0), kStart + kFrame));
  EXPECT_TRUE(places.add(point(0.0, 0.0), kStart + 2 * kFrame));
  EXPECT_TRUE(places.add(point(1.0, 0.0), kStart + 3 * kFrame));
}

TEST(PlaceConfirmation, ForgetsAGlimpse) {
  PlaceConfirmation places{2, 0.5};
  EXPECT_FALSE(places.add(point(0.0, 0.0), kStart));
  EXPECT_FALSE(places.add(point(0.0, 0.0), kStart + std::chrono::seconds{6}));
}

TEST(OnMap, TurnsThePointAndAddsThePosesUncertainty) {
  const PoseHistory::Entry pose{
      {}, {1.0, 2.0, std::numbers::pi / 2}, Covariance3{Eigen::Vector3d{0.0, 0.0, 0.01}.asDiagonal()}};
  UncertainPoint in_base{{2.0, 0.0}, Eigen::Matrix2d::Zero()};
  in_base.covariance(0, 0) = 0.25;  // ahead

  const UncertainPoint in_map = on_map(in_base, pose);

  EXPECT_NEAR(in_map.position.x(), 1.0, 1e-12);
  EXPECT_NEAR(in_map.position.y(), 4.0, 1e-12);
  EXPECT_NEAR(in_map.covariance(1, 1), 0.25, 1e-12);
  EXPECT_NEAR(in_map.covariance(0, 0), 0.04, 1e-12);  // 0.1 rad at 2 m is 0.2 m
}

}  // namespace
}  // namespace tandem
