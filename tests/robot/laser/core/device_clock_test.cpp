#include "robot/laser/core/device_clock.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "services/common/random.hpp"

namespace tandem {
namespace {

constexpr Duration kPeriod = std::chrono::milliseconds{100};
constexpr Duration kDelay = std::chrono::milliseconds{20};
const Time kStart = from_stamp_ns(1'700'000'000'000'000'000);

TEST(DeviceClock, StampsBeforeArrivalByTheLeastDelay) {
  DeviceClock clock{kDelay};
  EXPECT_EQ(clock.mission_time(5000, kStart), kStart - kDelay);
  EXPECT_EQ(clock.mission_time(5100, kStart + kPeriod), kStart + kPeriod - kDelay);
}

TEST(DeviceClock, IsNotMovedByOneLateArrival) {
  DeviceClock clock{kDelay};
  (void)clock.mission_time(0, kStart);
  const Duration hiccup = std::chrono::milliseconds{60};
  EXPECT_EQ(clock.mission_time(100, kStart + kPeriod + hiccup), kStart + kPeriod - kDelay);
}

TEST(DeviceClock, GoesOnWhereTheCounterWraps) {
  DeviceClock clock{kDelay};
  (void)clock.mission_time(0xFFFFFF - 49, kStart);  // 50 ms before the wrap
  EXPECT_EQ(clock.mission_time(50, kStart + kPeriod), kStart + kPeriod - kDelay);
}

TEST(DeviceClock, FollowsASensorThatRunsFastThroughJitter) {
  DeviceClock clock{Duration::zero()};
  Rng rng{4};
  double worst_s = 0.0;
  for (int i = 0; i < 1200; ++i) {  // two minutes
    const Time measured = kStart + i * kPeriod;
    const auto timestamp_ms = static_cast<std::uint32_t>(std::lround(i * 100 * 1.001));  // 1000 ppm
    const Time received = measured + from_seconds(-0.004 * std::log(1.0 - rng.uniform()));
    const Time stamp = clock.mission_time(timestamp_ms & 0xFFFFFF, received);
    EXPECT_LE(stamp, received);
    if (i > 100) worst_s = std::max(worst_s, std::abs(to_seconds(stamp - measured)));
  }
  EXPECT_LT(worst_s, 0.004);  // 4 ms mean jitter, up to 30 ms
}

TEST(DeviceClock, FallsBackToArrivalWhenTheSensorsClockIsStuckOrJumps) {
  DeviceClock clock{kDelay};
  (void)clock.mission_time(1000, kStart);
  for (int i = 1; i <= 5; ++i) {
    EXPECT_EQ(clock.mission_time(1000, kStart + i * kPeriod), kStart + i * kPeriod - kDelay);  // stuck
  }
  EXPECT_EQ(clock.mission_time(900'000, kStart + 6 * kPeriod), kStart + 6 * kPeriod - kDelay);  // jumps
  EXPECT_EQ(clock.mission_time(900'100, kStart + 7 * kPeriod), kStart + 7 * kPeriod - kDelay);
}

}  // namespace
}  // namespace tandem
