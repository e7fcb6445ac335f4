#include "robot/safety/core/scan_monitor.hpp"

#include <gtest/gtest.h>

#include <functional>
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

TEST(ScanMonitor, TakesAScanOfAnImpossibleGeometryForNoScan) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<float> too_many(ScanMonitor::kMostBeams + 1, 4.0F);
  const std::vector<std::function<void(ScanView&)>> wrongs{
      [&](ScanView& scan) { scan.ranges_m = too_many; },
      [](ScanView& scan) { scan.angle_increment_rad = 0.0; },
      [](ScanView& scan) { scan.angle_increment_rad = 0.001; },  // a view of ten degrees
      [=](ScanView& scan) { scan.angle_min_rad = nan; },
      [=](ScanView& scan) { scan.base_from_laser.x = nan; },
      [=](ScanView& scan) { scan.base_from_laser.y = nan; },
      [=](ScanView& scan) { scan.base_from_laser.heading = nan; },
      [](ScanView& scan) { scan.range_max_m = scan.range_min_m; },
      [](ScanView& scan) { scan.range_min_m = -0.1; }};
  const auto ranges = room();
  for (std::size_t i = 0; i < wrongs.size(); ++i) {
    Laser laser;
    ScanMonitor monitor{kConfig};
    ScanView scan = laser.scan(ranges);
    wrongs[i](scan);
    monitor.take(scan, {}, kStart);
    EXPECT_TRUE(has(monitor.causes(kStart), Cause::StaleScan)) << i;
  }
}

TEST(ScanMonitor, IsAsOldAsItsStampWhereThatCanBeTrue) {
  using std::chrono::milliseconds;
  ScanMonitor monitor{kConfig};
  EXPECT_EQ(monitor.age_s(kStart), std::numeric_limits<double>::infinity());
  Laser laser;
  const auto ranges = room();
  ScanView scan = laser.scan(ranges);
  const auto age_of_stamp = [&](Duration before_arrival) {
    ++scan.sequence_number;
    scan.stamp = kStart - before_arrival;
    monitor.take(scan, {}, kStart);
    return monitor.age_s(kStart + milliseconds{50});
  };
  EXPECT_DOUBLE_EQ(age_of_stamp(milliseconds{100}), 0.15);
  EXPECT_DOUBLE_EQ(age_of_stamp(milliseconds{-100}), 0.05) << "from the future";
  EXPECT_DOUBLE_EQ(age_of_stamp(std::chrono::hours{1}), 0.05) << "of a clock that was set before a step";
}

TEST(ScanMonitor, CountsRepetitionsAnewAfterAPictureOfNothing) {
  ScanMonitor monitor{kConfig};
  Laser laser;
  const auto ranges = room();
  const std::vector<float> nothing(181, 0.0F);
  for (int i = 0; i < 9; ++i) monitor.take(laser.scan(ranges), {0.01 * i, 0.0, 0.0}, kStart);
  monitor.take(laser.scan(nothing), {}, kStart);
  monitor.take(laser.scan(ranges), {0.2, 0.0, 0.0}, kStart);
  EXPECT_FALSE(monitor.causes(kStart).any());
}

}  // namespace
}  // namespace tandem::safety
