#include "services/map_builder/core/drive_log.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace tandem {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

LaserScan scan_at(double seconds, float range_m = 2.0F) {
  return {.time = Time{from_seconds(seconds)},
          .angle_min_rad = -std::numbers::pi / 2.0,
          .angle_increment_rad = std::numbers::pi / 100.0,
          .range_max_m = 50.0,
          .ranges_m = std::vector<float>(101, range_m)};
}
OdometrySample wheels_at(double seconds, double x) {
  return {Time{from_seconds(seconds)}, {x, 0.0, 0.0}, {}, 0};
}
std::size_t faults(const Drive& drive, InputFault fault) {
  return drive.faults.count(fault);
}

TEST(DriveLog, PairsEachScanWithTheWheels) {
  DriveLog log{{}};
  log.add_odometry(wheels_at(1.0, 0.0));
  log.add_scan(scan_at(1.0, 2.0F));
  log.add_odometry(wheels_at(2.0, 1.0));
  log.add_scan(scan_at(2.0, 1.0F));
  const Drive drive = log.take();
  ASSERT_EQ(drive.scans.size(), 2U);
  EXPECT_FALSE(drive.scans[0].motion.has_value());
  EXPECT_NEAR(drive.scans[1].motion->x, 1.0, 1e-9);
  EXPECT_EQ(drive.scans[0].endpoints_in_base.size(), 101U);
}

TEST(DriveLog, LeavesOutBeamsThatAreNoNumbers) {
  DriveLog log{{}};
  log.add_odometry(wheels_at(1.0, 0.0));
  LaserScan scan = scan_at(1.0);
  scan.ranges_m[0] = kNan;
  scan.ranges_m[1] = kInfinity;
  scan.ranges_m[2] = -kInfinity;
  scan.ranges_m[3] = 0.0F;
  scan.ranges_m[4] = 1e30F;
  log.add_scan(scan);
  EXPECT_EQ(log.take().scans.at(0).endpoints_in_base.size(), 96U);
}

TEST(DriveLog, RefusesAScanThatSeesTooLittle) {
  DriveLog log{{}};
  log.add_odometry(wheels_at(1.0, 0.0));
  log.add_scan(scan_at(1.0, kNan));
  LaserScan empty = scan_at(2.0);
  empty.ranges_m.clear();
  log.add_scan(empty);
  const Drive drive = log.take();
  EXPECT_TRUE(drive.scans.empty());
  EXPECT_EQ(faults(drive, InputFault::ScanWithTooFewReturns), 2U);
  EXPECT_EQ(drive.scans_seen, 2U);
}

TEST(DriveLog, RefusesAScanOlderThanTheLast) {
  DriveLog log{{}};
  log.add_odometry(wheels_at(1.0, 0.0));
  log.add_odometry(wheels_at(3.0, 1.0));
  log.add_scan(scan_at(2.0, 2.0F));
  log.add_scan(scan_at(1.5, 1.0F));
  const Drive drive = log.take();
  EXPECT_EQ(drive.scans.size(), 1U);
  EXPECT_EQ(faults(drive, InputFault::ScanOutOfOrder), 1U);
}

TEST(DriveLog, RefusesAStuckLaser) {
  DriveLog log{{}};
  for (int i = 0; i < 5; ++i) {
    log.add_odometry(wheels_at(1.0 + i, 0.25 * i));
    log.add_scan(scan_at(1.0 + i));
  }
  const Drive drive = log.take();
  EXPECT_EQ(faults(drive, InputFault::ScanStuck), 3U);  // after 0.5, 0.75 and 1 m
  EXPECT_EQ(drive.scans.size(), 2U);
}

TEST(DriveLog, RefusesAScanWithoutOdometry) {
  DriveLog log{{}};
  log.add_scan(scan_at(1.0));
  log.add_odometry(wheels_at(5.0, 0.0));
  const Drive drive = log.take();
  EXPECT_TRUE(drive.scans.empty());
  EXPECT_EQ(faults(drive, InputFault::ScanWithoutOdometry), 1U);
}

TEST(DriveLog, RefusesOdometryOfAClockThatWasSetBack) {
  DriveLog log{{}};
  log.add_odometry(wheels_at(100.0, 0.0));
  log.add_odometry(wheels_at(1.0, 0.1));
  log.add_odometry(wheels_at(100.2, 0.2));
  const Drive drive = log.take();
  EXPECT_EQ(drive.odometry.samples().size(), 2U);
  EXPECT_EQ(faults(drive, InputFault::OdometryOutOfOrder), 1U);
}

TEST(DriveLog, KnowsNoMotionAcrossAJump) {
  DriveLog log{{}};
  log.add_odometry(wheels_at(1.0, 0.0));
  log.add_scan(scan_at(1.0, 2.0F));
  log.add_odometry(wheels_at(1.2, 500.0));
  log.add_scan(scan_at(1.2, 1.0F));
  const Drive drive = log.take();
  ASSERT_EQ(drive.scans.size(), 2U);
  EXPECT_FALSE(drive.scans[1].motion.has_value());
  EXPECT_EQ(faults(drive, InputFault::OdometryJump), 1U);
}

TEST(DriveLog, ThinsOutTheScansOfARobotThatStandsStill) {
  DriveLog log{{}};
  for (int i = 0; i < 100; ++i) {
    log.add_odometry(wheels_at(1.0 + 0.1 * i, 0.0));
    log.add_scan(scan_at(1.0 + 0.1 * i, 2.0F + 0.001F * static_cast<float>(i)));
  }
  const Drive drive = log.take();
  EXPECT_GE(drive.scans.size(), 15U);  // one each half second: its wheels may slip
  EXPECT_LE(drive.scans.size(), 21U);
}

TEST(DriveLog, LeavesOutOdometryThatIsNoNumber) {
  DriveLog log{{}};
  log.add_odometry({Time{}, {std::nan(""), 0.0, 0.0}, {}, 0});
  EXPECT_TRUE(log.take().odometry.samples().empty());
}

}  // namespace
}  // namespace tandem
