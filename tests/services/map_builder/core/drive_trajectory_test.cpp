#include "services/map_builder/core/drive_trajectory.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

Time at_s(double seconds) {
  return Time{from_seconds(seconds)};
}

/// Scans at 0 s and 2 s; the wheels say 1 m a second.
Drive two_scans() {
  Drive drive;
  drive.scans = {{.time = at_s(0.0), .stamp = at_s(0.0)}, {.time = at_s(2.0), .stamp = at_s(2.0)}};
  drive.odometry =
      OdometryTrack{{{at_s(0.0), {0, 0, 0}, {}, 0}, {at_s(1.0), {1, 0, 0}, {}, 0}, {at_s(2.0), {2, 0, 0}, {}, 0}}};
  return drive;
}

TEST(DriveTrajectory, GoesAsTheWheelsSayBetweenScans) {
  const std::vector<Pose2> poses{{0, 0, 0}, {2, 0, 0}};
  const auto trajectory = trajectory_of(two_scans(), poses);
  ASSERT_EQ(trajectory.size(), 3U);
  EXPECT_NEAR(trajectory[1].map_from_base.x, 1.0, 1e-9);
}

TEST(DriveTrajectory, SharesWhatTheWheelsMissed) {
  const std::vector<Pose2> poses{{0, 0, 0}, {3, 0, 0}};  // 1 m more than they say
  EXPECT_NEAR(trajectory_of(two_scans(), poses)[1].map_from_base.x, 1.5, 1e-9);
}

TEST(DriveTrajectory, AddsNothingWhereTheWheelsBreak) {
  Drive drive = two_scans();
  drive.odometry =
      OdometryTrack{{{at_s(0.0), {0, 0, 0}, {}, 0}, {at_s(1.0), {1, 0, 0}, {}, 1}, {at_s(2.0), {2, 0, 0}, {}, 1}}};
  const std::vector<Pose2> poses{{0, 0, 0}, {2, 0, 0}};
  EXPECT_EQ(trajectory_of(drive, poses).size(), 2U);
}

TEST(DriveTrajectory, TellsPosesByTheRecordedStamps) {
  Drive drive = two_scans();
  // The middle sample was recorded late; its place in the order is kept.
  drive.odometry =
      OdometryTrack{{{at_s(0.0), {0, 0, 0}, {}, 0}, {at_s(2.5), {0.2, 0, 0}, {}, 0}, {at_s(2.0), {0.4, 0, 0}, {}, 0}}};
  drive.scans[1].time = drive.odometry.samples()[2].time;
  const std::vector<Pose2> poses{{0, 0, 0}, {0.4, 0, 0}};
  const auto trajectory = trajectory_of(drive, poses);
  ASSERT_EQ(trajectory.size(), 3U);
  EXPECT_EQ(trajectory[2].time, at_s(2.5));
  EXPECT_NEAR(trajectory[2].map_from_base.x, 0.2, 1e-9);
}

TEST(DriveTrajectory, BendsTheWayBetweenNodesToItsEnd) {
  MapGraph graph;
  graph.nodes.push_back({.scan = 0, .way_m = 0.0, .surface = SurfaceIndex{Surface{}}});
  graph.nodes.push_back({.scan = 2, .way_m = 2.0, .surface = SurfaceIndex{Surface{}}});
  graph.poses = {{0, 0, 0}, {2.0, 0.4, 0.0}};  // tracked to (2, 0), found at (2, 0.4)
  graph.chain = {{.from = 0, .to = 1, .from_pose_to_pose = {2.0, 0.0, 0.0}}};
  graph.places = {{0, {}}, {0, {1.0, 0.0, 0.0}}, {1, {}}};
  const auto poses = scan_poses(graph);
  ASSERT_EQ(poses.size(), 3U);
  EXPECT_NEAR(poses[1].x, 1.0, 1e-9);
  EXPECT_NEAR(poses[1].y, 0.2, 1e-9);
  EXPECT_NEAR(poses[2].y, 0.4, 1e-9);
}

}  // namespace
}  // namespace tandem
