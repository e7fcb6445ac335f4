#include "services/tracking/core/pose_history.hpp"

#include <gtest/gtest.h>

namespace tandem::tracking {
namespace {

Time at(double time_s) {
  return from_stamp_ns(0) + from_seconds(time_s);
}

TEST(PoseHistory, InterpolatesBetweenPosesAndGoesOnForALittle) {
  PoseHistory history{from_seconds(5.0), from_seconds(0.2)};
  EXPECT_FALSE(history.at(at(1.0)));
  history.add(at(1.0), {0.0, 0.0, 0.0});
  history.add(at(1.1), {0.1, 0.0, 0.2});

  EXPECT_NEAR(history.at(at(1.05))->x, 0.05, 1e-9);
  EXPECT_NEAR(history.at(at(1.05))->heading, 0.1, 1e-9);
  EXPECT_NEAR(history.at(at(1.2))->x, 0.2, 1e-9);
  EXPECT_FALSE(history.at(at(1.31)));
  EXPECT_FALSE(history.at(at(0.9)));
  EXPECT_TRUE(history.covers(at(1.05)));
  EXPECT_FALSE(history.covers(at(1.2)));
}

TEST(PoseHistory, ForgetsWhatIsOldAndIgnoresWhatIsNotNew) {
  PoseHistory history{from_seconds(1.0), from_seconds(0.2)};
  history.add(at(1.0), {1.0, 0.0, 0.0});
  history.add(at(0.5), {9.0, 0.0, 0.0});
  history.add(at(2.5), {2.0, 0.0, 0.0});
  EXPECT_FALSE(history.at(at(1.0)));
  EXPECT_EQ(history.at(at(2.5))->x, 2.0);
}

}  // namespace
}  // namespace tandem::tracking
