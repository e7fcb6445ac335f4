#include "services/map_builder/core/closure_finder.hpp"

#include <gtest/gtest.h>

#include "tests/services/map_builder/ring.hpp"

namespace tandem {
namespace {

/// The ring with the true poses, bent by a drift in heading that grows from the start.
MapGraph bent_ring(const test::RingDrive& ring, double drift_radpm) {
  MapGraph graph;
  const MapBuilderConfig config;
  const Drive drive = test::recorded(ring, config);
  Pose2 pose;
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    if (i > 0) pose = pose * (inverse(ring.truth[i - 1]) * ring.truth[i]) * Pose2{0.0, 0.0, 0.25 * drift_radpm};
    Surface surface = surface_of(drive.scans[i].endpoints_in_base, Eigen::Vector2d::Zero(), 180);
    graph.nodes.push_back(
        {.scan = i, .way_m = 0.25 * static_cast<double>(i), .surface = SurfaceIndex{std::move(surface)}});
    graph.poses.push_back(pose);
  }
  return graph;
}

TEST(ClosureFinder, SeesWhereTheRobotCameBack) {
  const auto ring = test::drive_around(46.0, 0.0);  // once around is 41.6 m
  const MapGraph graph = bent_ring(ring, 0.001);
  ClosureFinder finder{{}};
  const auto closure = finder.add(graph);
  ASSERT_TRUE(closure.has_value());
  const Pose2 truth = inverse(ring.truth[closure->edge.from]) * ring.truth[closure->edge.to];
  const Pose2 error = inverse(truth) * closure->edge.from_pose_to_pose;
  EXPECT_LT(error.position().norm(), 0.1);
  EXPECT_LT(std::abs(error.heading), 0.02);
  EXPECT_LT(graph.nodes[closure->edge.from].way_m, 10.0);
}

TEST(ClosureFinder, AsksForASecondLookWhenTheCorrectionIsLarge) {
  const auto ring = test::drive_around(46.0, 0.0);
  MapGraph graph = bent_ring(ring, 0.001);
  MapBuilderConfig config;
  config.closure_far_m = 0.001;
  ClosureFinder finder{config};
  EXPECT_FALSE(finder.add(graph).has_value());
  EXPECT_EQ(finder.memory().doubted, 1U);
  graph = bent_ring(test::drive_around(48.5, 0.0), 0.001);
  EXPECT_TRUE(finder.add(graph).has_value());
}

TEST(ClosureFinder, FindsNothingWhereTheRobotHasNotBeen) {
  const MapGraph graph = bent_ring(test::drive_around(30.0, 0.0), 0.0);
  EXPECT_FALSE(ClosureFinder{{}}.add(graph).has_value());
}

TEST(ClosureFinder, LooksOnlyEachSoManyMetres) {
  const MapGraph graph = bent_ring(test::drive_around(46.0, 0.0), 0.001);
  ClosureFinder finder{{}};
  ASSERT_TRUE(finder.add(graph).has_value());
  EXPECT_FALSE(finder.add(graph).has_value());
}

}  // namespace
}  // namespace tandem
