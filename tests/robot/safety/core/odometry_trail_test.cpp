#include "robot/safety/core/odometry_trail.hpp"

#include <gtest/gtest.h>

namespace tandem::safety {
namespace {

constexpr Time kStart{std::chrono::seconds{1000}};
constexpr Duration kStep = std::chrono::milliseconds{50};

/// 0.1 m ahead in each step, from odometry that looks the other way than the map.
OdometryTrail ten_steps(std::uint32_t last_epoch = 1) {
  OdometryTrail trail;
  for (int i = 0; i < 10; ++i)
    trail.take({5.0 - 0.1 * i, 0.0, from_degrees(180)}, i < 9 ? 1 : last_epoch, kStart + i * kStep);
  return trail;
}

TEST(OdometryTrail, MovesAPoseOnByWhatTheWheelsTurnedSince) {
  const Pose2 now = ten_steps().moved_on({2.0, 3.0, from_degrees(90)}, kStart + 5 * kStep);
  EXPECT_NEAR(now.x, 2.0, 1e-12);
  EXPECT_NEAR(now.y, 3.4, 1e-12);
  EXPECT_NEAR(now.heading, from_degrees(90), 1e-12);
}

TEST(OdometryTrail, LeavesAPoseWhereItIsThatIsNewerOrOlderThanAllItKnows) {
  EXPECT_EQ(ten_steps().moved_on({2.0, 3.0, 0.0}, kStart + 20 * kStep), (Pose2{2.0, 3.0, 0.0}));
  EXPECT_EQ(ten_steps().moved_on({2.0, 3.0, 0.0}, kStart - kStep), (Pose2{2.0, 3.0, 0.0}));
  EXPECT_EQ(OdometryTrail{}.moved_on({2.0, 3.0, 0.0}, kStart), (Pose2{2.0, 3.0, 0.0}));
}

TEST(OdometryTrail, DoesNotMoveAcrossABreakOfTheOdometry) {
  EXPECT_EQ(ten_steps(2).moved_on({2.0, 3.0, 0.0}, kStart + 5 * kStep), (Pose2{2.0, 3.0, 0.0}));
}

}  // namespace
}  // namespace tandem::safety
