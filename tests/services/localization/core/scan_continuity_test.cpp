#include "services/localization/core/scan_continuity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tandem {
namespace {

using Points = std::vector<Eigen::Vector2d>;

const Eigen::Vector2d kNoArm = Eigen::Vector2d::Zero();

/// 360 beams, one in each degree, all around the base at (0, 0).
Points round_room(double radius_m) {
  Points points;
  for (int degree = 0; degree < 360; ++degree) {
    const double angle_rad = degree * std::numbers::pi / 180.0;
    points.push_back(radius_m * Eigen::Vector2d{std::cos(angle_rad), std::sin(angle_rad)});
  }
  return points;
}

/// The same from a square room with walls at x, y = -4 and 4, with the base somewhere in it.
Points square_room(const Pose2& room_from_base) {
  Points points;
  for (int degree = 0; degree < 360; ++degree) {
    const double angle_rad = degree * std::numbers::pi / 180.0;
    const Eigen::Vector2d away{std::cos(angle_rad + room_from_base.heading),
                               std::sin(angle_rad + room_from_base.heading)};
    const double by_x = ((away.x() > 0.0 ? 4.0 : -4.0) - room_from_base.x) / away.x();
    const double by_y = ((away.y() > 0.0 ? 4.0 : -4.0) - room_from_base.y) / away.y();
    points.push_back(std::min(by_x, by_y) * Eigen::Vector2d{std::cos(angle_rad), std::sin(angle_rad)});
  }
  return points;
}

TEST(ScanContinuity, FindsNoContradictionInTheSameScan) {
  EXPECT_DOUBLE_EQ(contradiction_of(round_room(4.0), round_room(4.0), kNoArm, {}, {}), 0.0);
}

TEST(ScanContinuity, CountsBeamsThatEndInWhatWasFree) {
  // All of the smaller room lies in what was free; the larger one's walls are behind those of the smaller.
  EXPECT_DOUBLE_EQ(contradiction_of(round_room(4.0), round_room(2.0), kNoArm, {}, {}), 0.5);
  EXPECT_DOUBLE_EQ(contradiction_of(round_room(2.0), round_room(4.0), kNoArm, {}, {}), 0.5);
}

TEST(ScanContinuity, FindsLittleWhereAPersonWalksBy) {
  Points with_person = round_room(4.0);
  for (int i = 100; i < 120; ++i) with_person[i] *= 0.5;

  EXPECT_NEAR(contradiction_of(round_room(4.0), with_person, kNoArm, {}, {}), 20.0 / 720.0, 1e-9);
}

TEST(ScanContinuity, FindsNoneWhereTheRobotMovedAsTheWheelsSay) {
  const Pose2 before{-1.0, 0.5, 0.3};
  const Pose2 motion{0.4, 0.0, -0.2};

  EXPECT_DOUBLE_EQ(contradiction_of(square_room(before), square_room(before * motion), kNoArm, motion, {}), 0.0);
}

TEST(ScanContinuity, TellsAMotionThatTheWheelsMissed) {
  const Pose2 before{-1.0, 0.5, 0.3};
  const Pose2 motion{1.5, 0.0, -0.2};

  const double missed =
      contradiction_of(square_room(before), square_room(before * motion), kNoArm, Pose2{0.0, 0.0, -0.2}, {});
  EXPECT_GT(missed, 0.2);
  // ... unless the wheels may well have missed that much.
  EXPECT_DOUBLE_EQ(contradiction_of(square_room(before), square_room(before * motion), kNoArm, Pose2{0.0, 0.0, -0.2},
                                    {.forward_m = 1.5, .sideways_m = 0.0, .turn_rad = 0.1}),
                   0.0);
}

TEST(ScanContinuity, LooksFromWhereTheLaserIs) {
  // Seen from the base all beams of the second scan would end before those of the first; seen from the laser they are
  // on the same lines, and not shorter.
  const Eigen::Vector2d arm{3.0, 0.0};
  Points from_arm = round_room(1.0);
  for (Eigen::Vector2d& point : from_arm) point += arm;

  EXPECT_DOUBLE_EQ(contradiction_of(from_arm, from_arm, arm, {}, {}), 0.0);
  EXPECT_GT(contradiction_of(round_room(4.0), from_arm, arm, {}, {}), 0.1);
}

TEST(ScanContinuity, SaysNothingOfTooFewBeams) {
  Points few = round_room(4.0);
  Points short_ones = round_room(2.0);
  few.resize(30);
  short_ones.resize(30);

  EXPECT_DOUBLE_EQ(contradiction_of(few, short_ones, kNoArm, {}, {}), 0.0);
}

}  // namespace
}  // namespace tandem
