#include "services/map_builder/core/scan_tracker.hpp"

#include <gtest/gtest.h>

#include "tests/services/map_builder/ring.hpp"

namespace tandem {
namespace {

/// How far the tracked poses are from the truth at most [m], all from the first.
double largest_error_m(const test::RingDrive& ring, const Drive& drive, const MapBuilderConfig& config) {
  MapGraph graph;
  ScanTracker tracker{config};
  for (std::size_t i = 0; i < drive.scans.size(); ++i) (void)tracker.add(i, drive.scans[i], graph);
  double largest = 0.0;
  for (std::size_t i = 0; i < graph.places.size(); ++i) {
    const Pose2 found = graph.poses[graph.places[i].node] * graph.places[i].node_from_base;
    const Pose2 truth = inverse(ring.truth.front()) * ring.truth[i];
    largest = std::max(largest, (found.position() - truth.position()).norm());
  }
  return largest;
}

TEST(ScanTracker, FollowsARobotWhoseWheelsTurnTooMuch) {
  const MapBuilderConfig config;
  const auto ring = test::drive_around(12.0, 0.05);
  const Drive drive = test::recorded(ring, config);
  ASSERT_EQ(drive.scans.size(), ring.scans.size());
  EXPECT_LT(largest_error_m(ring, drive, config), 0.1);
}

TEST(ScanTracker, FindsMotionThatTheWheelsMissed) {
  const MapBuilderConfig config;
  const auto ring = test::drive_around(12.0, 0.0);
  Drive drive = test::recorded(ring, config);
  for (std::size_t i = 20; i < 26; ++i) drive.scans[i].motion = Pose2{0.05, 0.0, 0.0};  // of 0.25 m
  EXPECT_LT(largest_error_m(ring, drive, config), 0.15);
}

TEST(ScanTracker, GoesOnWithoutWheels) {
  const MapBuilderConfig config;
  const auto ring = test::drive_around(6.0, 0.0);
  Drive drive = test::recorded(ring, config);
  drive.scans[10].motion.reset();
  EXPECT_LT(largest_error_m(ring, drive, config), 0.1);
}

TEST(ScanTracker, MakesANodeOfEachScanThatMovedFarEnough) {
  MapBuilderConfig config;
  config.node_spacing_m = 0.6;
  config.node_spacing_rad = 3.0;
  const auto ring = test::drive_around(6.0, 0.0);
  const Drive drive = test::recorded(ring, config);
  MapGraph graph;
  ScanTracker tracker{config};
  for (std::size_t i = 0; i < drive.scans.size(); ++i) (void)tracker.add(i, drive.scans[i], graph);
  EXPECT_EQ(graph.nodes.size(), 9U);  // each third of 25 scans
  EXPECT_EQ(graph.chain.size(), graph.nodes.size() - 1);
  EXPECT_EQ(graph.places.size(), drive.scans.size());
}

}  // namespace
}  // namespace tandem
