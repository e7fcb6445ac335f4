#include "services/recorder/core/ros_frames.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tandem::ros {
namespace {

constexpr double kRightAngle = std::numbers::pi / 2.0;

Transform joint(const std::string& parent, const std::string& child, Pose2 pose, bool is_upside_down = false) {
  return {{0, parent}, child, pose, is_upside_down};
}

TEST(RosFrames, AreJoinedAlongTheirChain) {
  Frames frames;
  frames.learn(joint("base_footprint", "base_link", {0.0, 0.0, kRightAngle}));
  frames.learn(joint("base_link", "laser", {2.0, 0.0, 0.0}));
  const auto laser = frames.base_from("base_footprint", "laser");
  ASSERT_TRUE(laser);
  EXPECT_NEAR(laser->pose.x, 0.0, 1e-12);
  EXPECT_NEAR(laser->pose.y, 2.0, 1e-12);
  EXPECT_FALSE(laser->is_mirrored);
}

TEST(RosFrames, WhatMovesAboveBothDoesNotMatter) {
  Frames frames;
  frames.learn(joint("odom", "base", {7.0, 3.0, 1.0}));
  frames.learn(joint("base", "mast", {1.0, 0.0, 0.0}));
  frames.learn(joint("base", "laser", {0.5, 0.25, 0.0}));
  EXPECT_NEAR(frames.base_from("base", "laser")->pose.x, 0.5, 1e-12);
  EXPECT_NEAR(frames.base_from("mast", "laser")->pose.x, -0.5, 1e-12);
}

TEST(RosFrames, TheFirstTransformOfAFrameHolds) {
  Frames frames;
  frames.learn(joint("base", "laser", {0.5, 0.0, 0.0}));
  frames.learn(joint("base", "laser", {9.0, 0.0, 0.0}));
  EXPECT_EQ(frames.base_from("base", "laser")->pose.x, 0.5);
}

TEST(RosFrames, ThatAreNotJoinedHaveNoPlace) {
  Frames frames;
  frames.learn(joint("odom", "base", {}));
  EXPECT_FALSE(frames.base_from("base", "laser"));
  frames.learn(joint("a", "b", {}));
  frames.learn(joint("b", "a", {}));  // a circle ends
  EXPECT_FALSE(frames.base_from("base", "a"));
}

TEST(RosFrames, UnderAMountThatHangsUpsideDownLeftIsRight) {
  Frames frames;
  frames.learn(joint("base", "mount", {1.0, 0.0, 0.0}, true));
  frames.learn(joint("mount", "laser", {0.0, 0.5, 0.25}));
  const auto laser = frames.base_from("base", "laser");
  ASSERT_TRUE(laser);
  EXPECT_EQ(laser->pose.y, -0.5);
  EXPECT_EQ(laser->pose.heading, -0.25);
  EXPECT_TRUE(laser->is_mirrored);
}

TEST(RosFrames, AScanTurnedUpHasItsBeamsTheOtherWayRound) {
  LaserScan scan;
  scan.angle_min_rad = -0.5;
  scan.angle_increment_rad = 0.25;
  scan.ranges_m = {1.0F, 2.0F, 3.0F};  // at -0.5, -0.25 and 0
  const LaserScan turned = turned_up(scan);
  EXPECT_EQ(turned.angle_min_rad, 0.0);
  EXPECT_EQ(turned.ranges_m, (std::vector<float>{3.0F, 2.0F, 1.0F}));
}

}  // namespace
}  // namespace tandem::ros
