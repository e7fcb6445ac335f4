#include "services/map_builder/core/odometry_track.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

Time at_s(double seconds) {
  return Time{from_seconds(seconds)};
}

OdometrySample sample(double seconds, double x, int epoch = 0) {
  return {at_s(seconds), {x, 0.0, 0.0}, {}, epoch};
}

TEST(OdometryTrack, InterpolatesBetweenSamples) {
  const OdometryTrack track{{sample(1.0, 0.0), sample(2.0, 1.0)}};
  EXPECT_NEAR(track.at(at_s(1.25), {})->odom_from_base.x, 0.25, 1e-9);
  EXPECT_FALSE(track.at(at_s(0.9), {}).has_value());
}

TEST(OdometryTrack, CarriesTheLastSampleOnForAWhile) {
  OdometrySample last = sample(1.0, 0.0);
  last.velocity.forward_mps = 2.0;
  const OdometryTrack track{{last}};
  EXPECT_NEAR(track.at(at_s(1.1), from_seconds(0.2))->odom_from_base.x, 0.2, 1e-9);
  EXPECT_FALSE(track.at(at_s(1.3), from_seconds(0.2)).has_value());
}

TEST(OdometryTrack, BreaksWhereTheBaseStartsAnew) {
  const OdometryTrack track{{sample(1.0, 5.0, 0), sample(2.0, 0.0, 1)}};
  EXPECT_NE(track.samples()[0].epoch, track.samples()[1].epoch);
  EXPECT_EQ(track.jumps(), 0U);
  EXPECT_FALSE(track.at(at_s(1.5), from_seconds(0.2)).has_value());
}

TEST(OdometryTrack, BreaksAtAJumpAndCountsIt) {
  const OdometryTrack track{{sample(1.0, 0.0), sample(1.2, 100.0), sample(1.4, 100.1)}};
  EXPECT_EQ(track.jumps(), 1U);
  EXPECT_NE(track.samples()[0].epoch, track.samples()[1].epoch);
  EXPECT_EQ(track.samples()[1].epoch, track.samples()[2].epoch);
}

TEST(OdometryTrack, TrustsTheOrderBeforeTheStamps) {
  // The second sample's stamp is a second late.
  const OdometryTrack track{{sample(1.0, 0.0), sample(2.2, 0.1), sample(1.4, 0.2)}};
  EXPECT_LE(track.samples()[1].time, at_s(1.4));
  EXPECT_LT(track.samples()[1].time, track.samples()[2].time);
  EXPECT_EQ(track.stamps()[1], at_s(2.2));  // by which others know it
  EXPECT_EQ(track.jumps(), 0U);
}

TEST(OdometryTrack, SpreadsABurstOfOneStamp) {
  const OdometryTrack track{{sample(1.0, 0.0), sample(2.0, 0.1), sample(2.0, 0.2), sample(2.0, 0.3), sample(3.0, 0.4)}};
  EXPECT_LT(track.samples()[1].time, track.samples()[2].time);
  EXPECT_EQ(track.samples()[2].time, at_s(2.0));
  EXPECT_LT(track.samples()[2].time, track.samples()[3].time);
  EXPECT_NEAR(to_seconds(track.samples()[3].time - track.samples()[1].time), 0.0067, 1e-4);  // of 10 ms
}

TEST(OdometryTrack, HoldsNothingOfNothing) {
  EXPECT_FALSE(OdometryTrack{}.at(at_s(1.0), from_seconds(1.0)).has_value());
}

}  // namespace
}  // namespace tandem
