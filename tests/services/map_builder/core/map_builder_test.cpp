#include "services/map_builder/core/map_builder.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "services/localization/core/trajectory_errors.hpp"
#include "services/map_builder/core/build_checkpoint.hpp"
#include "tests/services/map_builder/ring.hpp"

namespace tandem {
namespace {

BuiltMap built(const test::RingDrive& ring, const MapBuilderConfig& config) {
  return build_map(test::recorded(ring, config), config);
}

TEST(MapBuilder, BuildsTheRingAndClosesItsLoop) {
  const auto ring = test::drive_around(60.0, 0.03);
  const MapBuilderConfig config;
  const BuiltMap map = built(ring, config);
  ASSERT_EQ(map.scan_poses.size(), ring.truth.size());
  EXPECT_GE(map.closures.size(), 3U);
  EXPECT_EQ(map.rejected, 0U);
  std::vector<TimedPose> truth;
  for (std::size_t i = 0; i < ring.truth.size(); ++i) truth.push_back({ring.scans[i].time, ring.truth[i]});
  const FormErrors errors = form_errors_of(map.scan_poses, truth, 0.0);
  EXPECT_LT(errors.rmse_m, 0.05);
  EXPECT_LT(errors.max_m, 0.15);
  // The block in the middle of the ring is a wall, and the way of the robot free.
  for (const TimedPose& pose : map.scan_poses) {
    EXPECT_EQ(map.grid.at(pose.map_from_base.position()), CellState::Free);
  }
}

TEST(MapBuilder, GivesEqualBytesForEqualInput) {
  const auto ring = test::drive_around(48.0, 0.03);
  const BuiltMap one = built(ring, {});
  const BuiltMap other = built(ring, {});
  EXPECT_EQ(one.grid, other.grid);
  EXPECT_EQ(trajectory_text(one.trajectory), trajectory_text(other.trajectory));
}

TEST(MapBuilder, DoesNotCareWhereTheOdometryBegan) {
  const BuiltMap here = built(test::drive_around(20.0, 0.03), {});
  const BuiltMap there = built(test::drive_around(20.0, 0.03, {100.0, -50.0, 2.0}), {});
  ASSERT_EQ(here.scan_poses.size(), there.scan_poses.size());
  for (std::size_t i = 0; i < here.scan_poses.size(); ++i) {
    const Pose2 apart = inverse(here.scan_poses[i].map_from_base) * there.scan_poses[i].map_from_base;
    EXPECT_LT(apart.position().norm(), 1e-4) << i;
    EXPECT_LT(std::abs(apart.heading), 1e-4) << i;
  }
}

TEST(MapBuilder, TurnsWithALaserThatIsTurned) {
  // The base turned by 0.7 rad under the laser: the world as the base sees it turns the other way.
  const auto ring = test::drive_around(20.0, 0.03);
  auto turned = ring;
  const Pose2 base_from_new_base{0.0, 0.0, 0.7};
  for (LaserScan& scan : turned.scans) scan.base_from_laser = inverse(base_from_new_base) * scan.base_from_laser;
  for (OdometrySample& sample : turned.odometry) sample.odom_from_base = sample.odom_from_base * base_from_new_base;
  MapBuilderConfig config;  // wheels alike in both directions, as the law wants it
  config.wheels.sideways_per_m = config.wheels.forward_per_m;
  const BuiltMap here = built(ring, config);
  const BuiltMap there = built(turned, config);
  ASSERT_EQ(here.scan_poses.size(), there.scan_poses.size());
  for (std::size_t i = 0; i < here.scan_poses.size(); ++i) {
    const Pose2 expected = inverse(base_from_new_base) * here.scan_poses[i].map_from_base * base_from_new_base;
    EXPECT_LT((expected.position() - there.scan_poses[i].map_from_base.position()).norm(), 0.03) << i;
  }
}

TEST(MapBuilder, IsTheSameHoweverOftenItWasWrittenDownAndReadAgain) {
  const auto ring = test::drive_around(60.0, 0.03);
  const MapBuilderConfig config;
  const Drive drive = test::recorded(ring, config);
  const BuiltMap whole = build_map(drive, config);
  ASSERT_GE(whole.closures.size(), 3U);

  // Stopped after each third piece of work: amid scans, before poses settle, amid both rounds of neighbours.
  const BuildKey key = key_of(drive, config, "this program");
  BuildState state;
  std::set<BuildStage> stages;
  for (bool done = false; !done;) {
    MapBuild build{drive, config, std::move(state)};
    for (int i = 0; i < 3; ++i) build.advance();
    stages.insert(build.state().stage);
    done = build.is_done();
    CheckpointReading reading = read_checkpoint(checkpoint_of(build.state(), key), key, drive, config);
    ASSERT_TRUE(reading.state.has_value()) << reading.refusal;
    state = *std::move(reading.state);
  }
  EXPECT_GE(stages.size(), 3U);
  const auto resumed = MapBuild{drive, config, std::move(state)}.drawn([](const BuildProgress&) { return true; });
  ASSERT_TRUE(resumed.has_value());
  EXPECT_EQ(resumed->grid, whole.grid);
  EXPECT_EQ(trajectory_text(resumed->trajectory), trajectory_text(whole.trajectory));
  EXPECT_EQ(resumed->scan_poses.size(), whole.scan_poses.size());
  for (std::size_t i = 0; i < whole.scan_poses.size(); ++i) {
    EXPECT_EQ(resumed->scan_poses[i].map_from_base, whole.scan_poses[i].map_from_base) << i;  // to the last bit
  }
  EXPECT_EQ(resumed->closures.size(), whole.closures.size());
}

TEST(MapBuilder, DrawsNothingWhenStoppedWhileItDraws) {
  const MapBuilderConfig config;
  const Drive drive = test::recorded(test::drive_around(5.0, 0.0), config);
  MapBuild build{drive, config};
  double share = 0.0;
  while (!build.is_done()) {
    build.advance();
    EXPECT_GE(build.progress().share, share);
    share = build.progress().share;
  }
  EXPECT_FALSE(build.drawn([](const BuildProgress&) { return false; }).has_value());
}

TEST(MapBuilder, MakesNoMapOfNoScans) {
  const BuiltMap map = build_map({}, {});
  EXPECT_TRUE(map.grid.empty());
  EXPECT_TRUE(map.trajectory.empty());
}

TEST(MapBuilder, SurvivesALogWithFaults) {
  auto ring = test::drive_around(20.0, 0.03);
  for (float& range : ring.scans[10].ranges_m) range = std::numeric_limits<float>::quiet_NaN();
  for (float& range : ring.scans[15].ranges_m) range = std::numeric_limits<float>::infinity();
  ring.odometry[30].odom_from_base.x += 1000.0;
  ring.scans[40].time = ring.scans[20].time;
  const MapBuilderConfig config;
  const Drive drive = test::recorded(ring, config);
  EXPECT_EQ(drive.faults.count(InputFault::ScanWithTooFewReturns), 2U);
  EXPECT_EQ(drive.faults.count(InputFault::OdometryJump), 2U);  // there, and back
  EXPECT_EQ(drive.faults.count(InputFault::ScanOutOfOrder), 1U);
  const BuiltMap map = build_map(drive, config);
  EXPECT_LT(map.grid.width() * map.grid.resolution_m(), 40.0);
}

TEST(MapBuilder, NamesItsParameters) {
  MapBuilderConfig other;
  other.resolution_m = 0.1;
  EXPECT_EQ(hash_of({}).size(), 16U);
  EXPECT_NE(hash_of({}), hash_of(other));
}

}  // namespace
}  // namespace tandem
