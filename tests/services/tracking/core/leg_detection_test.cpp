#include "services/tracking/core/leg_detection.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "tests/services/tracking/core/leg_scene.hpp"

namespace tandem::tracking {
namespace {

const TrackingConfig kConfig;

/// A hall around the origin whose walls are 10 m away, with a pillar of 0.2 m at (3, 2).
DistanceField hall() {
  OccupancyGrid grid{202, 202, 0.1, {-10.1, -10.1, 0.0}, CellState::Free};
  for (int i = 0; i < 202; ++i) {
    for (const CellIndex cell : {CellIndex{i, 0}, CellIndex{i, 201}, CellIndex{0, i}, CellIndex{201, i}}) {
      grid.set(cell, CellState::Occupied);
    }
  }
  for (int column = 130; column < 132; ++column) {
    for (int row = 120; row < 122; ++row) grid.set({column, row}, CellState::Occupied);
  }
  return DistanceField{grid, 1.0};
}

TEST(LegDetection, SeesTwoLegsAsOnePersonBetweenThem) {
  const DistanceField map = hall();
  const auto legs = find_legs(kConfig, scan_of(all_legs({{3.0, 0.0}})), {}, {}, &map);
  ASSERT_EQ(legs.size(), 2u);

  const auto people = pair_legs(kConfig, legs);

  ASSERT_EQ(people.size(), 1u);
  EXPECT_TRUE(people[0].pair);
  EXPECT_NEAR((people[0].position_in_map - Eigen::Vector2d(3.0, 0.0)).norm(), 0.0, 0.03);
}

TEST(LegDetection, PlacesThemByThePoseOfTheLaser) {
  const Pose2 map_from_laser{1.0, 1.0, std::numbers::pi / 2.0};
  const auto scan = scan_of(all_legs({{3.0, 0.0}}));
  const auto people = pair_legs(kConfig, find_legs(kConfig, scan, map_from_laser, map_from_laser, nullptr));
  ASSERT_EQ(people.size(), 1u);
  EXPECT_NEAR((people[0].position_in_map - Eigen::Vector2d(1.0, 4.0)).norm(), 0.0, 0.03);
}

TEST(LegDetection, WhatTheMapExplainsIsNoLeg) {
  const DistanceField map = hall();
  const LaserScan scan = scan_of({{{3.0, 2.0}, 0.1}});  // the pillar
  EXPECT_TRUE(find_legs(kConfig, scan, {}, {}, &map).empty());
  EXPECT_EQ(find_legs(kConfig, scan, {}, {}, nullptr).size(), 1u);
}

TEST(LegDetection, SeesAPersonFarAwayWithAMap) {
  const DistanceField map = hall();
  const auto people = pair_legs(kConfig, find_legs(kConfig, scan_of(all_legs({{8.5, 0.0}})), {}, {}, &map));
  ASSERT_EQ(people.size(), 1u);
  EXPECT_NEAR((people[0].position_in_map - Eigen::Vector2d(8.5, 0.0)).norm(), 0.0, 0.15);
}

TEST(LegDetection, AWallIsNoLeg) {
  EXPECT_TRUE(find_legs(kConfig, scan_of({}, 4.0), {}, {}, nullptr).empty());
}

TEST(LegDetection, LegsFartherApartThanAStrideAreTwoPeople) {
  const auto people = pair_legs(kConfig, {{{3.0, 0.0}, 0.12, 3.0, false}, {{3.0, 1.0}, 0.12, 3.0, false}});
  ASSERT_EQ(people.size(), 2u);
  EXPECT_FALSE(people[0].pair);
}

TEST(LegDetection, PairsTheClosestFirst) {
  // Two people beside each other, 0.3 m between the legs of one and 0.4 m between the inner legs of both.
  const auto leg = [](double y) { return Leg{{3.0, y}, 0.12, 3.0, false}; };
  const auto people = pair_legs(kConfig, {leg(0.0), leg(0.3), leg(0.7), leg(1.0)});
  ASSERT_EQ(people.size(), 2u);
  EXPECT_NEAR(people[0].position_in_map.y(), 0.15, 1e-9);
  EXPECT_NEAR(people[1].position_in_map.y(), 0.85, 1e-9);
}

TEST(LegDetection, AnEmptyScanShowsNobody) {
  LaserScan scan;
  EXPECT_TRUE(find_legs(kConfig, scan, {}, {}, nullptr).empty());
  scan.ranges_m.assign(361, std::numeric_limits<float>::quiet_NaN());
  scan.range_max_m = 30.0;
  EXPECT_TRUE(find_legs(kConfig, scan, {}, {}, nullptr).empty());
}

}  // namespace
}  // namespace tandem::tracking
