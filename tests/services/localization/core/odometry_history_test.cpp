#include "services/localization/core/odometry_history.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tandem {
namespace {

Time at(double seconds) {
  return Time{from_seconds(seconds)};
}

OdometryHistory one_metre_in_a_second() {
  OdometryHistory history{from_seconds(0.2)};
  history.add({at(10.0), {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0});
  history.add({at(11.0), {1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0});
  return history;
}

TEST(OdometryHistory, InterpolatesBetweenSamples) {
  EXPECT_NEAR(one_metre_in_a_second().at(at(10.25))->odom_from_base.x, 0.25, 1e-12);
  EXPECT_NEAR(one_metre_in_a_second().at(at(11.0))->odom_from_base.x, 1.0, 1e-12);
}

TEST(OdometryHistory, CarriesTheLastSampleOnForAShortWhile) {
  EXPECT_NEAR(one_metre_in_a_second().at(at(11.2))->odom_from_base.x, 1.2, 1e-12);
  EXPECT_FALSE(one_metre_in_a_second().at(at(11.21)).has_value());
}

TEST(OdometryHistory, KnowsNothingBeforeItsFirstSample) {
  EXPECT_FALSE(one_metre_in_a_second().at(at(9.999)).has_value());
}

TEST(OdometryHistory, SortsSamplesThatComeLate) {
  OdometryHistory history = one_metre_in_a_second();
  history.add({at(10.5), {0.9, 0.0, 0.0}, {}, 0});

  EXPECT_NEAR(history.at(at(10.75))->odom_from_base.x, 0.95, 1e-12);
}

TEST(OdometryHistory, ForgetsThePastWhenAnEpochBegins) {
  OdometryHistory history = one_metre_in_a_second();
  history.add({at(11.1), {0.0, 0.0, 0.0}, {}, 1});

  EXPECT_FALSE(history.at(at(10.5)).has_value());
  EXPECT_EQ(history.at(at(11.1))->epoch, 1);
}

TEST(MotionOf, FollowsTheChordOfTheArc) {
  const Pose2 quarter = motion_of({std::numbers::pi / 2.0, 0.0, std::numbers::pi / 2.0}, from_seconds(1.0));

  EXPECT_NEAR(quarter.heading, std::numbers::pi / 2.0, 1e-12);
  EXPECT_NEAR(quarter.x, quarter.y, 1e-12);  // a quarter of a circle ends at 45 degrees
}

TEST(OdometryHistory, TellsALateSampleFromATimeThatWentBack) {
  OdometryHistory history{from_seconds(0.2)};
  const auto add = [&](double seconds, double x) {
    return history.add({Time{from_seconds(seconds)}, {x, 0.0, 0.0}, {}, 0});
  };
  EXPECT_EQ(add(100.0, 0.0), OdometryOrder::InOrder);
  EXPECT_EQ(add(101.0, 1.0), OdometryOrder::InOrder);
  EXPECT_EQ(add(100.5, 0.8), OdometryOrder::Late);
  EXPECT_DOUBLE_EQ(history.at(Time{from_seconds(100.5)})->odom_from_base.x, 0.8);

  EXPECT_EQ(add(50.0, 2.0), OdometryOrder::WentBack);
  EXPECT_FALSE(history.at(Time{from_seconds(101.0)}));
  EXPECT_DOUBLE_EQ(history.newest()->odom_from_base.x, 2.0);
}

TEST(OdometryHistory, IsNotHeldUpByOneStampFromTheFuture) {
  OdometryHistory history{from_seconds(0.2)};
  (void)history.add({Time{from_seconds(10.0)}, {1.0, 0.0, 0.0}, {}, 0});
  (void)history.add({Time{from_seconds(3600.0)}, {1.0, 0.0, 0.0}, {}, 0});
  (void)history.add({Time{from_seconds(10.1)}, {2.0, 0.0, 0.0}, {}, 0});

  EXPECT_DOUBLE_EQ(history.at(Time{from_seconds(10.1)})->odom_from_base.x, 2.0);
  EXPECT_FALSE(history.at(Time{from_seconds(20.0)}));
}

}  // namespace
}  // namespace tandem
