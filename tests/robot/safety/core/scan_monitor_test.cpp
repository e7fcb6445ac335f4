#include "robot/safety/core/scan_monitor.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <vector>

namespace tandem::safety {
namespace {

constexpr Time kStart{std::chrono::seconds{1000}};
const GateConfig kConfig{};

class Laser {
 public:
  ScanView scan(const std::vector<float>& ranges) {
    return {.sequence_number = ++number_,
            .stamp = kStart,
            .base_from_laser = {0.16, 0.0, 0.0},
            .angle_min_rad = -std::numbers::pi / 2.0,
            .angle_increment_rad = std::numbers::pi / 180.0,
            .range_min_m = 0.02,
            .range_max_m = 30.0,
            .ranges_m = ranges};
  }

 private:
  std::uint64_t number_ = 0;
};

std::vector<float> room() {
  std::vector<float> ranges(181, 4.0F);
  ranges[90] = 2.0F;
  return ranges;
}

bool has(const Causes& causes, Cause cause) {
  return causes.test(index_of(cause));
}

TEST(ScanMonitor, PlacesWhatItHitsInTheFrameOfTheBase) {
  ScanMonitor monitor{kConfig};
  Laser laser;
  monitor.take(laser.scan(room()), {}, kStart);

  ASSERT_EQ(monitor.points_in_base().size(), 181u);
  EXPECT_NEAR(monitor.points_in_base()[90].x(), 2.16, 1e-6);  // straight ahead
  EXPECT_NEAR(monitor.points_in_base()[90].y(), 0.0, 1e-6);
  EXPECT_FALSE(monitor.causes(kStart).any());
}

TEST(ScanMonitor, IsStaleBeforeTheFirstScanAndAfter300Milliseconds) {
  ScanMonitor monitor{kConfig};
  EXPECT_TRUE(has(monitor.causes(kStart), Cause::StaleScan));
  Laser laser;
  monitor.take(laser.scan(room()), {}, kStart);
  EXPECT_FALSE(has(monitor.causes(kStart + std::chrono::milliseconds{300}), Cause::StaleScan));
  EXPECT_TRUE(has(monitor.causes(kStart + std::chrono::milliseconds{301}), Cause::StaleScan));
}

TEST(ScanMonitor, TakesAScanOfWrongShapeForNoScan) {
  Laser laser;
  const std::vector<float> none;
  const std::vector<float> few(5, 1.0F);
  const std::vector<float> many(400, 1.0F);  // more than a turn at one degree each
  for (const auto* ranges : {&none, &few, &many}) {
    ScanMonitor monitor{kConfig};
    monitor.take(laser.scan(*ranges), {}, kStart);
    EXPECT_TRUE(has(monitor.causes(kStart), Cause::StaleScan)) << ranges->size();
  }
}

TEST(ScanMonitor, CallsAScanBadThatSeesNothingUsable) {
  Laser laser;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<float> third_invalid = room();
  for (std::size_t i = 0; i < 60; ++i) third_invalid[i] = i % 3 == 0 ? nan : (i % 3 == 1 ? -1.0F : 0.0F);
  const std::vector<float> third = third_invalid;
  const std::vector<float> all_far(181, 30.0F);
  const std::vector<float> all_zero(181, 0.0F);
  const std::vector<float> all_same(181, 1.5F);
  for (const auto* ranges : {&third, &all_far, &all_zero, &all_same}) {
    ScanMonitor monitor{kConfig};
    monitor.take(laser.scan(*ranges), {}, kStart);
    EXPECT_TRUE(has(monitor.causes(kStart), Cause::BadScan));
  }
}

TEST(ScanMonitor, ForgivesAFewInvalidBeams) {
  Laser laser;
  std::vector<float> ranges = room();
  for (std::size_t i = 0; i < 50; ++i) ranges[i] = std::numeric_limits<float>::quiet_NaN();
  ScanMonitor monitor{kConfig};
  monitor.take(laser.scan(ranges), {}, kStart);
  EXPECT_FALSE(monitor.causes(kStart).any());
}

TEST(ScanMonitor, NoticesAPictureThatStandsStillWhileTheRobotMoves) {
  ScanMonitor monitor{kConfig};
  Laser laser;
  for (int i = 0; i < 30; ++i) monitor.take(laser.scan(room()), {}, kStart);  // standing: nothing wrong
  EXPECT_FALSE(has(monitor.causes(kStart), Cause::StuckScan));
  for (int i = 0; i < 10; ++i) monitor.take(laser.scan(room()), {0.01 * i, 0.0, 0.0}, kStart);
  EXPECT_TRUE(has(monitor.causes(kStart), Cause::StuckScan));
}

TEST(ScanMonitor, CountsTheSameScanOnce) {
  ScanMonitor monitor{kConfig};
  Laser laser;
  const auto ranges = room();
  const ScanView scan = laser.scan(ranges);
  monitor.take(scan, {}, kStart);
  monitor.take(scan, {}, kStart + std::chrono::milliseconds{301});
  EXPECT_TRUE(has(monitor.causes(kStart + std::chrono::milliseconds{301}), Cause::StaleScan));
}

}  // namespace
}  // namespace tandem::safety
