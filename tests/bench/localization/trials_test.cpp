#include "bench/localization/trials.hpp"

#include <gtest/gtest.h>

namespace tandem::bench {
namespace {

/// A robot that drives 1 m a second along the x axis, with odometry that began at (5, 0).
RecordedLog straight_log() {
  RecordedLog log{.name = "straight", .map_file = {}, .map = {}, .events = {}, .truth = {}};
  for (int i = 0; i <= 20; ++i) {
    const Time time{from_seconds(i)};
    log.events.emplace_back(OdometrySample{time, {5.0 + i, 0.0, 0.0}, {}, 0});
    log.truth.push_back({time, {1.0 * i, 0.0, 0.0}});
  }
  return log;
}

TEST(CarriedLog, GoesOnElsewhereWithWheelsThatStoodStill) {
  const RecordedLog log = carried(straight_log(), Time{from_seconds(3.0)}, Time{from_seconds(10.0)}, 5.0);

  ASSERT_EQ(log.truth.size(), 4U + 6U);
  EXPECT_EQ(log.truth[4].time, Time{from_seconds(4.0)});  // a second after the lift
  EXPECT_EQ(log.truth[4].map_from_base.x, 10.0);
  EXPECT_EQ(std::get<OdometrySample>(log.events[3]).odom_from_base.x, 8.0);
  EXPECT_EQ(std::get<OdometrySample>(log.events[4]).odom_from_base.x, 8.0);
  EXPECT_EQ(std::get<OdometrySample>(log.events[5]).odom_from_base.x, 9.0);
}

TEST(Trials, CallAPoseRightWithinHalfAMetreAndTenDegrees) {
  EXPECT_TRUE(is_right({0.3, 0.4, 0.0}, {}));
  EXPECT_FALSE(is_right({0.4, 0.4, 0.0}, {}));
  EXPECT_FALSE(is_right({0.0, 0.0, from_degrees(11.0)}, {}));
}

TEST(RecordedLog, TellsTheWayByTheTruth) {
  const RecordedLog log = straight_log();

  EXPECT_EQ(time_after_way(log, Time{from_seconds(2.0)}, 4.0), Time{from_seconds(6.0)});
  EXPECT_DOUBLE_EQ(way_between_m(log, Time{from_seconds(2.0)}, Time{from_seconds(6.0)}), 4.0);
}

}  // namespace
}  // namespace tandem::bench
