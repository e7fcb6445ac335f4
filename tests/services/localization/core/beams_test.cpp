#include "services/localization/core/beams.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace tandem {
namespace {

constexpr double kQuarterTurn = std::numbers::pi / 2.0;

/// Right, ahead, left.
LaserScan three_beams(float right, float ahead, float left) {
  return {.angle_min_rad = -kQuarterTurn,
          .angle_increment_rad = kQuarterTurn,
          .range_min_m = 0.1,
          .range_max_m = 30.0,
          .ranges_m = {right, ahead, left}};
}

void expect_point(const Eigen::Vector2d& point, double x, double y) {
  EXPECT_NEAR(point.x(), x, 1e-9);
  EXPECT_NEAR(point.y(), y, 1e-9);
}

TEST(Beams, EndWhereTheLaserSaysSeenFromTheBase) {
  LaserScan scan = three_beams(1.0F, 2.0F, 3.0F);
  scan.base_from_laser = {0.5, 0.0, 0.0};

  const auto points = selected_endpoints(scan, 10, 25.0, {});

  ASSERT_EQ(points.size(), 3U);
  expect_point(points[0], 0.5, -1.0);
  expect_point(points[1], 2.5, 0.0);
  expect_point(points[2], 0.5, 3.0);
}

TEST(Beams, WithoutAReturnAreLeftOut) {
  EXPECT_EQ(selected_endpoints(three_beams(std::numeric_limits<float>::quiet_NaN(), 29.0F, 0.05F), 10, 25.0, {}).size(),
            0U);  // no return, beyond the limit, below the minimum
  EXPECT_EQ(selected_endpoints(three_beams(-1.0F, std::numeric_limits<float>::infinity(), 5.0F), 10, 25.0, {}).size(),
            1U);
}

TEST(Beams, AreChosenEvenly) {
  LaserScan scan{.angle_increment_rad = 0.001, .range_max_m = 10.0, .ranges_m = std::vector<float>(90, 1.0F)};

  const auto points = selected_endpoints(scan, 9, 25.0, {});

  ASSERT_EQ(points.size(), 9U);
  EXPECT_NEAR(std::atan2(points[0].y(), points[0].x()), 0.005, 1e-9);
  EXPECT_NEAR(std::atan2(points[8].y(), points[8].x()), 0.085, 1e-9);
}

TEST(Beams, AreMovedBackToTheTimeOfTheFirst) {
  LaserScan scan = three_beams(1.0F, 1.0F, 1.0F);
  scan.beam_interval_s = 0.5;

  const auto points = selected_endpoints(scan, 10, 25.0, {.forward_mps = 1.0});

  expect_point(points[0], 0.0, -1.0);
  expect_point(points[1], 1.5, 0.0);  // half a second later the base is half a metre on
  expect_point(points[2], 1.0, 1.0);
}

}  // namespace
}  // namespace tandem
