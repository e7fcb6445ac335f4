#include "robot/laser/core/scan_filter.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "services/common/angle.hpp"

namespace tandem {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr double kStep_rad = from_degrees(0.5);

LaserReading reading(std::vector<float> ranges_m) {
  LaserReading out;
  out.angle_increment_rad = kStep_rad;
  out.ranges_m = std::move(ranges_m);
  return out;
}

/// "1 2 -": ranges, a dash for NaN.
std::string text(const std::vector<float>& ranges) {
  std::string all;
  for (const float range : ranges) {
    char word[16];
    std::snprintf(word, sizeof word, "%g", static_cast<double>(range));
    all += (all.empty() ? "" : " ") + (std::isnan(range) ? std::string{"-"} : std::string{word});
  }
  return all;
}

ScanFilter veils() {
  LaserConfig config;
  config.veil_angle_rad = from_degrees(5.0);
  return ScanFilter{config};
}

ScanFilter dirt() {
  LaserConfig config;
  config.dirt_range_m = 0.05;
  return ScanFilter{config};
}

std::string filtered(ScanFilter filter, std::vector<float> ranges_m) {
  LaserReading scan = reading(std::move(ranges_m));
  filter.apply(scan);
  return text(scan.ranges_m);
}

TEST(ScanFilter, ChangesNothingUnlessItIsAskedTo) {
  EXPECT_EQ(filtered(ScanFilter{LaserConfig{}}, {1, 2, 3, 0.01f}), "1 2 3 0.01");
}

TEST(ScanFilter, TakesAwayWhatHangsBetweenAnEdgeAndTheWallBehind) {
  EXPECT_EQ(filtered(veils(), {1, 1, 1, 2, 3, 3, 3}), "1 1 1 - 3 3 3");
  EXPECT_EQ(filtered(veils(), {3, 3, 2, 1, 1}), "3 3 - 1 1");
  EXPECT_EQ(filtered(veils(), {1, 1, 1.5f, 2.5f, 3, 3}), "1 1 - - 3 3") << "one veil does not hide the next";
}

TEST(ScanFilter, LeavesBothSidesOfAnEdge) {
  EXPECT_EQ(filtered(veils(), {1, 1, 3, 3}), "1 1 3 3");
  EXPECT_EQ(filtered(veils(), {3, 3, 1, 3, 3}), "3 3 1 3 3") << "a thin pole is no veil";
}

TEST(ScanFilter, NeverTakesTheNearestOfItsNeighbours) {
  for (const auto& ranges : {std::vector<float>{5, 1, 5}, {5, 1, 1, 5}, {2, 1, 3}}) {
    EXPECT_NE(filtered(veils(), ranges).find("1"), std::string::npos);
  }
}

TEST(ScanFilter, LeavesAWallThatIsSeenAtAFlatAngle) {
  std::vector<float> wall;
  for (int i = 0; i < 100; ++i) wall.push_back(static_cast<float>(1.0 / std::cos(i * kStep_rad)));  // up to 50 degrees
  for (int i = 100; i < 165; ++i) wall.push_back(static_cast<float>(1.0 / std::cos(i * kStep_rad)));  // up to 82
  LaserReading scan = reading(wall);
  veils().apply(scan);
  EXPECT_EQ(scan.ranges_m, wall);
}

TEST(ScanFilter, WithoutBothNeighboursNothingIsAVeil) {
  EXPECT_EQ(filtered(veils(), {1, 2, kNone}), "1 2 -");
  EXPECT_EQ(filtered(veils(), {1, 2}), "1 2");
  EXPECT_EQ(filtered(veils(), {}), "");
}

TEST(ScanFilter, TakesASpotAwayThatStaysAndTellsOfIt) {
  ScanFilter filter = dirt();
  for (int i = 0; i < 49; ++i) {
    LaserReading scan = reading({1, 0.03f, 0.03f, 1});
    filter.apply(scan);
    ASSERT_EQ(text(scan.ranges_m), "1 0.03 0.03 1") << "scan " << i;
    ASSERT_EQ(filter.complaint(), "");
  }
  LaserReading scan = reading({1, 0.03f, 0.03f, 1});
  filter.apply(scan);
  EXPECT_EQ(text(scan.ranges_m), "1 - - 1");
  EXPECT_EQ(filter.complaint(), "2 beams end at the window: clean it");
  scan = reading({1, 2, 2, 1});
  filter.apply(scan);
  EXPECT_EQ(text(scan.ranges_m), "1 2 2 1");
  EXPECT_EQ(filter.complaint(), "");
}

TEST(ScanFilter, WhatCoversMoreOfTheWindowIsLeftForTheGate) {  // fault S5
  ScanFilter filter = dirt();
  const std::vector<float> covered(7, 0.03f);  // 3.5 degrees
  for (int i = 0; i < 200; ++i) {
    LaserReading scan = reading(covered);
    filter.apply(scan);
    ASSERT_EQ(scan.ranges_m, covered);
  }
  EXPECT_EQ(filter.complaint(), "");
}

TEST(ScanFilter, WhatGrowsFromASpotIsLeftToo) {
  ScanFilter filter = dirt();
  for (int i = 0; i < 60; ++i) {
    LaserReading scan = reading({1, 0.03f, 1, 1});
    filter.apply(scan);
  }
  LaserReading scan = reading({1, 0.03f, 0.03f, 1});
  filter.apply(scan);
  EXPECT_EQ(text(scan.ranges_m), "1 0.03 0.03 1") << "something new is beside it";
}

TEST(ScanFilter, WhatIsFartherThanTheWindowIsNoDirt) {
  ScanFilter filter = dirt();
  for (int i = 0; i < 100; ++i) {
    LaserReading scan = reading({1, 0.06f, 1});
    filter.apply(scan);
    ASSERT_EQ(text(scan.ranges_m), "1 0.06 1");
  }
}

TEST(ScanFilter, BeginsAnewWhenTheScansAreOthers) {
  ScanFilter filter = dirt();
  for (int i = 0; i < 60; ++i) {
    LaserReading scan = reading({1, 0.03f, 1, 1});
    filter.apply(scan);
  }
  LaserReading scan = reading({1, 0.03f, 1});
  filter.apply(scan);
  EXPECT_EQ(text(scan.ranges_m), "1 0.03 1");
}

}  // namespace
}  // namespace tandem
