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

}  // namespace
}  // namespace tandem
