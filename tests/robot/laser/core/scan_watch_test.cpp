#include "robot/laser/core/scan_watch.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tandem {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// Adds `count` scans, one each `period_ms`, the first beam 1 mm farther from scan to scan if they are `alive`.
void add_scans(ScanWatch& watch, int count, int period_ms, bool alive, float second_beam_m = 2.0f) {
  for (int i = 0; i < count; ++i) {
    LaserReading reading;
    reading.first_beam = Time{} + i * std::chrono::milliseconds{period_ms};
    reading.ranges_m = {alive ? 1.0f + 0.001f * static_cast<float>(i % 7) : 1.0f, second_beam_m};
    watch.add(reading);
  }
}

TEST(ScanWatch, HasNothingToSayOfAGoodStream) {
  ScanWatch watch{0.1};
  add_scans(watch, 50, 100, true, kNone);
  EXPECT_EQ(watch.complaint(), "");
}

TEST(ScanWatch, NamesAStuckSensorAfterTenIdenticalScans) {  // fault S2
  ScanWatch watch{0.1};
  add_scans(watch, 9, 100, false, kNone);
  EXPECT_EQ(watch.complaint(), "");
  add_scans(watch, 1, 100, false, kNone);
  EXPECT_EQ(watch.complaint(), "10 identical scans in a row: the sensor is stuck");
  add_scans(watch, 2, 100, true, kNone);
  EXPECT_EQ(watch.complaint(), "");
}

TEST(ScanWatch, NamesABlindSensor) {  // fault S3
  ScanWatch watch{0.1};
  LaserReading blind;
  blind.ranges_m = {kNone, kNone};
  watch.add(blind);
  EXPECT_EQ(watch.complaint(), "no beam returns: is the laser covered?");
}

TEST(ScanWatch, NamesASlowSensor) {  // fault S6
  ScanWatch watch{0.1};
  add_scans(watch, 20, 250, true);
  EXPECT_EQ(watch.complaint(), "scans come every 250 ms instead of 100");
}

}  // namespace
}  // namespace tandem
