#include "calibration/core/wheel_motion.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

Time at(double seconds) {
  return Time{from_seconds(seconds)};
}

OdometryTrack track() {
  return OdometryTrack{{{at(0.0), {0.0, 0.0, 0.0}, {}, 0},
                        {at(1.0), {1.0, 0.0, 0.0}, {}, 0},
                        {at(2.0), {2.0, 0.0, 0.0}, {}, 0},
                        {at(3.0), {9.0, 9.0, 0.0}, {}, 1},
                        {at(4.0), {9.0, 9.0, 0.0}, {}, 1}}};
}

TEST(WheelMotion, FollowsARobotThatSpeedsUpBetweenSamples) {
  // x = t^2 / 2, read once a second.
  std::vector<OdometrySample> samples;
  for (int i = 0; i <= 6; ++i) samples.push_back({at(i), {0.5 * i * i, 0.0, 0.0}, {}, 0});
  const auto motion = wheel_motion(OdometryTrack{std::move(samples)}, at(1.5), at(3.5));
  ASSERT_TRUE(motion);
  double way_m = 0.0;
  for (const Arc<double>& step : motion->steps) way_m += step.forward_m;
  EXPECT_NEAR(way_m, 0.5 * (3.5 * 3.5 - 1.5 * 1.5), 1e-9);
  EXPECT_NEAR(motion->rate_at_start.forward_m, 1.5, 1e-9);
  EXPECT_NEAR(motion->rate_at_end.forward_m, 3.5, 1e-9);
}

TEST(WheelMotion, IsCutWhereItBeginsAndEnds) {
  const auto motion = wheel_motion(track(), at(0.5), at(1.25));
  ASSERT_TRUE(motion);
  ASSERT_EQ(motion->steps.size(), 2u);
  EXPECT_NEAR(motion->steps[0].forward_m, 0.5, 1e-9);
  EXPECT_NEAR(motion->steps[1].forward_m, 0.25, 1e-9);
  EXPECT_NEAR(motion->rate_at_start.forward_m, 1.0, 1e-9);
}

TEST(WheelMotion, IsNoneOverABreakOrBeyondTheEnd) {
  EXPECT_FALSE(wheel_motion(track(), at(1.5), at(3.0)));
  EXPECT_FALSE(wheel_motion(track(), at(-1.0), at(1.0)));
  EXPECT_FALSE(wheel_motion(track(), at(3.5), at(4.5)));
}

}  // namespace
}  // namespace tandem
