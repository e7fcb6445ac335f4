#include "services/localization/core/map_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "services/localization/core/beams.hpp"
#include "tests/services/localization/room.hpp"

namespace tandem {
namespace {

/// What the beams of a scan from `pose` in the room tell about a map of it that is `scale` times as large.
ScaleMeasurement measured(const Pose2& pose, double scale, double longer_m = 0.0) {
  const OccupancyGrid room = test::uneven_room();
  OccupancyGrid map{room.width(), room.height(), scale * room.resolution_m(), room.map_from_grid()};
  std::copy(room.cells().begin(), room.cells().end(), map.cells().begin());
  LaserScan scan = test::scan_from(room, pose, Time{});
  for (float& range : scan.ranges_m) range += static_cast<float>(longer_m);
  const Pose2 in_map{scale * pose.x, scale * pose.y, pose.heading};
  return scale_measurement(DistanceField{map, 2.0}, selected_endpoints(scan, 180, 25.0, {}), in_map,
                           scan.base_from_laser.position());
}

TEST(ScaleMeasurement, FindsHowMuchTooLargeTheMapIs) {
  for (const Pose2& pose : {Pose2{2.5, 1.2, 0.0}, Pose2{3.0, 2.0, 1.0}}) {
    const double right = measured(pose, 1.0).log_scale;
    EXPECT_NEAR(right, 0.0, 0.02);  // half a cell of 10 cm at 2 m or 3 m
    EXPECT_NEAR(measured(pose, 1.05).log_scale - right, std::log(1.05), 0.015);
    EXPECT_GT(measured(pose, 1.05).information, 100.0);
  }
}

TEST(ScaleMeasurement, TakesWallsThatAreALittleThinnerForWhatTheyAre) {
  const Pose2 pose{2.5, 1.2, 0.0};
  const double change = measured(pose, 1.0, 0.02).log_scale - measured(pose, 1.0).log_scale;
  EXPECT_LT(std::abs(change), 0.01);  // 2 cm at 2 m would be as much
}

TEST(ScaleMeasurement, TellsNothingWithoutBeams) {
  const OccupancyGrid room = test::uneven_room();
  const ScaleMeasurement nothing = scale_measurement(DistanceField{room, 2.0}, {}, {1.0, 1.0, 0.0}, {0.0, 0.0});
  EXPECT_EQ(nothing.log_scale, 0.0);
  EXPECT_NEAR(nothing.information, 0.0, 1e-9);
}

TEST(MapScaleWatch, NamesAScaleThatIsMeasuredAgainAndAgain) {
  MapScaleWatch watch{{}};
  for (double way_m = 0.0; way_m < 11.9; way_m += 0.5) watch.add({0.03, 1000.0}, way_m);
  EXPECT_FALSE(watch.wrong_scale());  // too little way
  watch.add({0.03, 1000.0}, 12.0);
  ASSERT_TRUE(watch.wrong_scale());
  EXPECT_NEAR(*watch.wrong_scale(), std::exp(0.03), 1e-9);
}

TEST(MapScaleWatch, SaysNothingOfWhatScansDoNotAgreeAbout) {
  MapScaleWatch watch;
  for (int i = 0; i < 60; ++i) watch.add({i % 2 == 0 ? 0.2 : -0.16, 1000.0}, 0.5 * i);  // 0.02 on average
  EXPECT_FALSE(watch.wrong_scale());
}

TEST(MapScaleWatch, KeepsItsWordUntilTheScaleIsClearlyRight) {
  MapScaleWatch watch;
  double way_m = 0.0;
  const auto drive = [&](double log_scale) {
    for (int i = 0; i < 50; ++i) watch.add({log_scale, 1000.0}, way_m += 0.5);  // longer than is remembered
  };
  drive(-0.03);
  EXPECT_TRUE(watch.wrong_scale());
  drive(-0.015);
  EXPECT_TRUE(watch.wrong_scale());
  drive(0.005);
  EXPECT_FALSE(watch.wrong_scale());
  drive(-0.015);
  EXPECT_FALSE(watch.wrong_scale());
}

TEST(MapScaleWatch, AsksForMoreOnACoarseMap) {
  EXPECT_EQ(map_scale_options(0.02).named, MapScaleOptions{}.named);
  EXPECT_EQ(map_scale_options(0.1).named, 2.0 * MapScaleOptions{}.named);
  EXPECT_EQ(map_scale_options(0.1).cleared, 2.0 * MapScaleOptions{}.cleared);
}

TEST(MapScaleWatch, WantsAMeasurementEachQuarterOfAMetre) {
  MapScaleWatch watch;
  EXPECT_TRUE(watch.is_due(0.0));
  watch.add({0.0, 1000.0}, 0.0);
  EXPECT_FALSE(watch.is_due(0.2));
  EXPECT_TRUE(watch.is_due(0.25));
}

}  // namespace
}  // namespace tandem
