#include "services/localization/core/laser_scan.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "services/localization/core/beams.hpp"

namespace tandem {
namespace {

TEST(LaserScan, HasNoBeamsAndLiesInTheBaseUntilItIsSaid) {
  const LaserScan scan;
  EXPECT_TRUE(scan.ranges_m.empty());
  EXPECT_EQ(scan.base_from_laser, Pose2{});
  EXPECT_EQ(scan.time, Time{});
  EXPECT_TRUE(selected_endpoints(scan, 10, 30.0, {}).empty());
}

TEST(LaserScan, BeamsTurnByTheIncrementFromTheFirstOneOn) {
  const double quarter_turn = 0.5 * std::numbers::pi;
  LaserScan scan{.angle_min_rad = 0.0, .angle_increment_rad = quarter_turn, .range_max_m = 30.0, .ranges_m = {1, 2, 3}};
  auto points = selected_endpoints(scan, 10, 30.0, {});
  ASSERT_EQ(points.size(), 3U);
  EXPECT_NEAR((points[1] - Eigen::Vector2d{0.0, 2.0}).norm(), 0.0, 1e-9);
  EXPECT_NEAR((points[2] - Eigen::Vector2d{-3.0, 0.0}).norm(), 0.0, 1e-9);
  scan.angle_increment_rad = -quarter_turn;  // of a laser that hangs upside down
  points = selected_endpoints(scan, 10, 30.0, {});
  EXPECT_NEAR((points[1] - Eigen::Vector2d{0.0, -2.0}).norm(), 0.0, 1e-9);
}

TEST(LaserScan, BeamsAreMeasuredOneAfterTheOther) {
  // At 1 m/s the last of three beams, 0.2 s after the first, begins 0.2 m further on.
  const LaserScan scan{.beam_interval_s = 0.1, .range_max_m = 30.0, .ranges_m = {5, 5, 5}};
  Twist2 ahead;
  ahead.forward_mps = 1.0;
  const auto points = selected_endpoints(scan, 10, 30.0, ahead);
  ASSERT_EQ(points.size(), 3U);
  EXPECT_NEAR((points[2] - points[0]).norm(), 0.2, 1e-6);
}

}  // namespace
}  // namespace tandem
