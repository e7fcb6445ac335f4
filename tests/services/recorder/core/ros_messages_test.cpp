#include "services/recorder/core/ros_messages.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/services/recorder/core/ros_bytes.hpp"

namespace tandem::ros {
namespace {

constexpr double kRightAngle = std::numbers::pi / 2.0;

class RosMessages : public testing::TestWithParam<Wire> {
 protected:
  [[nodiscard]] std::string type(const std::string& package, const std::string& name) const {
    return package + (GetParam() == Wire::Cdr ? "/msg/" : "/") + name;
  }
  template <typename Kind>
  [[nodiscard]] Kind parsed(const std::string& package, const std::string& name, const mcap::Bytes& bytes) const {
    return std::get<Kind>(*parse(type(package, name), GetParam(), bytes));
  }
};

TEST_P(RosMessages, AScanIsWhatWasWritten) {
  const auto scan = parsed<LaserScan>("sensor_msgs", "LaserScan", scan_bytes(GetParam(), 7, "/laser"));
  EXPECT_EQ(scan.header.stamp_ns, 7'500'000'000);
  EXPECT_EQ(scan.header.frame, "laser");
  EXPECT_EQ(scan.angle_min_rad, -0.5);
  EXPECT_EQ(scan.angle_increment_rad, 0.5);
  EXPECT_EQ(scan.range_max_m, 8.0);
  EXPECT_EQ(scan.ranges_m, (std::vector<float>{1.0F, 2.0F, 3.0F}));
}

TEST_P(RosMessages, OdometryKeepsWhatLiesInThePlane) {
  const auto odometry = parsed<Odometry>("nav_msgs", "Odometry", odometry_bytes(GetParam(), 3, "base_link"));
  EXPECT_EQ(odometry.child_frame, "base_link");
  EXPECT_EQ(odometry.odom_from_base.x, 1.0);
  EXPECT_NEAR(odometry.odom_from_base.heading, kRightAngle, 1e-12);
  EXPECT_EQ(odometry.turn_rate_radps, 0.25);
  // Of the 6 x 6 matrix 0, 1, 2, … the rows and columns of x, y and the turn about z.
  EXPECT_EQ(odometry.covariance, (std::array<double, 9>{0, 1, 5, 6, 7, 11, 30, 31, 35}));
}

TEST_P(RosMessages, ATransformSaysWhetherItHangsUpsideDown) {
  for (const bool upside_down : {false, true}) {
    const auto all = parsed<Transforms>("tf2_msgs", "TFMessage",
                                        transform_bytes(GetParam(), "base_link", "laser", 0.5, 0.25, upside_down));
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].header.frame, "base_link");
    EXPECT_EQ(all[0].child_frame, "laser");
    EXPECT_EQ(all[0].parent_from_child.y, 0.25);
    EXPECT_NEAR(all[0].parent_from_child.heading, kRightAngle, 1e-12);
    EXPECT_EQ(all[0].is_upside_down, upside_down);
  }
}

TEST_P(RosMessages, AGridThatHasNotAsManyCellsAsItSaysIsNone) {
  const mcap::Bytes bytes = grid_bytes(GetParam());
  EXPECT_EQ(parsed<OccupancyGrid>("nav_msgs", "OccupancyGrid", bytes).cells, (std::vector<std::uint8_t>{0, 255}));
  mcap::Bytes one_less{bytes.begin(), bytes.end() - 1};
  one_less[one_less.size() - 5] = 1;
  EXPECT_FALSE(parse(type("nav_msgs", "OccupancyGrid"), GetParam(), one_less));
}

TEST_P(RosMessages, WhatIsCutShortIsNone) {
  const mcap::Bytes bytes = odometry_bytes(GetParam(), 3, "base_link");
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_FALSE(parse(type("nav_msgs", "Odometry"), GetParam(), mcap::ByteView{bytes}.first(length)));
  }
}

INSTANTIATE_TEST_SUITE_P(OnBothWires, RosMessages, testing::Values(Wire::Ros1, Wire::Cdr));

TEST(RosMessageTypes, AreKnownByBothTheirNames) {
  EXPECT_TRUE(is_known("sensor_msgs/LaserScan"));
  EXPECT_TRUE(is_known("sensor_msgs/msg/LaserScan"));
  EXPECT_TRUE(is_known("tf/tfMessage"));
  EXPECT_FALSE(is_known("sensor_msgs/msg/Image"));
}

}  // namespace
}  // namespace tandem::ros
