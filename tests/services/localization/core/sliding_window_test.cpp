#include "services/localization/core/sliding_window.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "services/common/random.hpp"
#include "services/localization/core/beams.hpp"
#include "tests/services/localization/room.hpp"

namespace tandem {
namespace {

/// What the filter says: a guess that is loosely held.
RefinedPose around(const Pose2& guess) {
  return {guess, Eigen::Vector3d{0.15 * 0.15, 0.15 * 0.15, 0.1 * 0.1}.asDiagonal()};
}

const MotionDeviation kWheels{0.01, 0.01, 0.005};

std::vector<Eigen::Vector2d> seen_from(const OccupancyGrid& map, const Pose2& pose, double range_limit_m = 25.0) {
  return selected_endpoints(test::scan_from(map, pose, Time{}), 180, range_limit_m, {});
}

OccupancyGrid blank_corridor() {
  OccupancyGrid corridor{200, 20, 0.1, {}, CellState::Free};
  for (int column = 0; column < 200; ++column) {
    corridor.set({column, 0}, CellState::Occupied);
    corridor.set({column, 19}, CellState::Occupied);
  }
  return corridor;
}

TEST(SlidingWindow, FollowsTheRobotFromRoughGuesses) {
  const OccupancyGrid map = test::uneven_room();
  const DistanceField field{map, 2.0};
  SlidingWindow window{field, {}};
  Rng rng{4};
  Pose2 truth{2.5, 1.2, 0.0};
  for (int i = 0; i < 30; ++i) {
    const Pose2 motion{0.05, 0.0, 0.05};
    truth = truth * motion;
    const Pose2 guess = truth * Pose2{rng.uniform(-0.1, 0.1), rng.uniform(-0.1, 0.1), rng.uniform(-0.05, 0.05)};
    const RefinedPose pose = window.add(around(guess), seen_from(map, truth), motion, kWheels);
    EXPECT_LT((pose.map_from_base.position() - truth.position()).norm(), 0.06) << "step " << i;
  }
}

TEST(SlidingWindow, GrowsUnsureAlongABlankCorridorAsItDrives) {
  const OccupancyGrid map = blank_corridor();
  const DistanceField field{map, 2.0};
  SlidingWindow window{field, {}};
  Pose2 truth{5.0, 1.0, 0.0};
  double before = 0.0;
  for (int i = 0; i < 20; ++i) {
    const Pose2 motion{0.2, 0.0, 0.0};
    truth = truth * motion;
    const RefinedPose pose = window.add(around(truth), seen_from(map, truth, 4.0), motion, kWheels);
    EXPECT_GT(pose.covariance(0, 0), before) << "step " << i;
    before = pose.covariance(0, 0);
    EXPECT_LT(std::sqrt(pose.covariance(1, 1)), 0.03);
  }
  EXPECT_GT(std::sqrt(before), 0.15);  // the first guess and twenty motions
}

TEST(SlidingWindow, StartsAnewWhereTheGuessIsFarFromWhatItExpects) {
  const OccupancyGrid map = test::uneven_room();
  const DistanceField field{map, 2.0};
  SlidingWindow window{field, {}};
  const Pose2 there{3.0, 2.0, 1.0};
  (void)window.add(around({2.0, 1.0, 0.0}), seen_from(map, {2.0, 1.0, 0.0}), {}, kWheels);

  const RefinedPose pose = window.add(around(there), seen_from(map, there), {}, kWheels);
  EXPECT_LT((pose.map_from_base.position() - there.position()).norm(), 0.06);
}

}  // namespace
}  // namespace tandem
