#include "robot/camera/core/pose_history.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

const Time kStart = from_stamp_ns(1'000'000'000'000);
constexpr Duration kFrame = std::chrono::milliseconds{200};

TEST(PoseHistory, InterpolatesBetweenPosesAndKnowsItsLimits) {
  PoseHistory history;
  EXPECT_TRUE(history.is_after_last(kStart));
  history.add({kStart, {0.0, 0.0, 0.0}});
  history.add({kStart + kFrame, {1.0, 0.0, 0.0}});
  history.add({kStart + 10 * kFrame, {2.0, 0.0, 0.0}});

  EXPECT_DOUBLE_EQ(history.at(kStart + kFrame / 2)->map_from_base.x, 0.5);
  EXPECT_DOUBLE_EQ(history.at(kStart)->map_from_base.x, 0.0);
  EXPECT_FALSE(history.at(kStart + 5 * kFrame)) << "the gap is too long";
  EXPECT_FALSE(history.at(kStart - kFrame));
  EXPECT_FALSE(history.at(kStart + 11 * kFrame));
  EXPECT_TRUE(history.is_after_last(kStart + 11 * kFrame));
}

}  // namespace
}  // namespace tandem
