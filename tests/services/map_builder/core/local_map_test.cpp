#include "services/map_builder/core/local_map.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

/// Two walls at a right angle.
Surface corner() {
  Surface surface;
  for (int i = 0; i <= 60; ++i) {
    surface.push_back({{0.1 * i - 3.0, 3.0}, {0.0, -1.0}});
    surface.push_back({{3.0, 0.1 * i - 3.0}, {-1.0, 0.0}});
  }
  return surface;
}

TEST(LocalMap, FindsThePoseInAWindow) {
  LocalMap map{corner(), {0.0, 0.0}, 6.0};
  const Pose2 truth{0.3, -0.2, 0.1};
  const Pose2 found =
      map.best_pose(inverse(truth) * corner(), {},
                    {.half_side_m = 0.5, .half_turn_rad = 0.2, .step_m = 0.1, .step_rad = 0.05, .prior_weight = 0.0});
  EXPECT_NEAR(found.x, 0.3, 0.11);
  EXPECT_NEAR(found.y, -0.2, 0.11);
  EXPECT_NEAR(found.heading, 0.1, 0.051);
}

TEST(LocalMap, IsDrawnWithinItsReachAlone) {
  const LocalMap map{corner(), {0.0, 0.0}, 2.0};  // the walls are 3 m away
  const OccupancyGrid grid = map.grid(0.5);
  EXPECT_EQ(grid.width(), 8);
  for (const CellState state : grid.cells()) EXPECT_EQ(state, CellState::Free);
}

TEST(LocalMap, HasAnOccupiedCellWhereSomethingWasSeen) {
  const LocalMap map{{{{1.0, 1.0}, {1.0, 0.0}}}, {0.0, 0.0}, 2.0};
  EXPECT_EQ(map.grid(0.1).at(Eigen::Vector2d{1.0, 1.0}), CellState::Occupied);
}

TEST(LocalMap, SearchesWithNearPointsAlone) {
  EXPECT_EQ(points_of({{{1.0, 0.0}, {1.0, 0.0}}, {{9.0, 0.0}, {1.0, 0.0}}}, 10, 5.0).size(), 1U);
}

}  // namespace
}  // namespace tandem
