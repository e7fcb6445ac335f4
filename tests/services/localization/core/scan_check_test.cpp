#include "services/localization/core/scan_check.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tandem {
namespace {

/// 40 beams; the first tells how far the robot has come.
LaserScan scan(float first_m, std::size_t beams = 40) {
  LaserScan scan;
  scan.range_max_m = 30.0;
  scan.angle_increment_rad = 0.01;
  scan.ranges_m.assign(beams, 2.0F);
  scan.ranges_m.front() = first_m;
  return scan;
}

TEST(ScanCheck, FindsNothingWrongWithScansThatChange) {
  ScanCheck check;
  for (int i = 0; i < 20; ++i)
    EXPECT_FALSE(check.fault_of(scan(1.0F + 0.01F * static_cast<float>(i)), {0.1 * i, 0, 0}));
}

TEST(ScanCheck, NamesALaserThatSeesTheVerySameElsewhere) {
  ScanCheck check;
  EXPECT_FALSE(check.fault_of(scan(1.0F), {0.0, 0.0, 0.0}));
  EXPECT_FALSE(check.fault_of(scan(1.0F), {0.3, 0.0, 0.0}));  // a robot that crawls may
  EXPECT_EQ(check.fault_of(scan(1.0F), {0.31, 0.0, 0.0}), InputFault::ScanStuck);
  EXPECT_FALSE(check.fault_of(scan(1.1F), {0.32, 0.0, 0.0}));
}

TEST(ScanCheck, NamesRangesThatAreAllAlike) {
  ScanCheck check;
  EXPECT_EQ(check.fault_of(scan(2.0F), {}), InputFault::ScanAllAlike);
  LaserScan few = scan(2.0F);
  for (std::size_t i = 19; i < 40; ++i) few.ranges_m[i] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(check.fault_of(few, {}));  // 19 returns may be alike by chance
}

TEST(ScanCheck, LeavesOutAScanOfAnotherGeometry) {
  ScanCheck check;
  (void)check.fault_of(scan(1.0F), {});
  EXPECT_EQ(check.fault_of(scan(1.1F, 39), {}), InputFault::ScanGeometryChanged);
  LaserScan turned = scan(1.2F);
  turned.base_from_laser.heading = 0.1;
  EXPECT_EQ(check.fault_of(turned, {}), InputFault::ScanGeometryChanged);
  EXPECT_FALSE(check.fault_of(scan(1.3F), {}));
}

TEST(ScanCheck, TakesAnotherGeometryThatStays) {
  ScanCheck check;
  (void)check.fault_of(scan(1.0F), {});
  for (int i = 0; i < 9; ++i) {
    EXPECT_EQ(check.fault_of(scan(1.1F + 0.1F * static_cast<float>(i), 50), {}), InputFault::ScanGeometryChanged);
  }
  EXPECT_FALSE(check.fault_of(scan(3.0F, 50), {}));  // the tenth
  EXPECT_EQ(check.fault_of(scan(3.1F), {}), InputFault::ScanGeometryChanged);
}

}  // namespace
}  // namespace tandem
