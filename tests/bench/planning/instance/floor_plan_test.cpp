#include "bench/planning/instance/floor_plan.hpp"

#include <gtest/gtest.h>

namespace tandem::bench {
namespace {

int free_cells(const OccupancyGrid& map) {
  int count = 0;
  for (const CellState cell : map.cells()) count += cell == CellState::Free ? 1 : 0;
  return count;
}

TEST(FloorPlan, AnEmptyPlanIsFreeInsideItsWall) {
  const OccupancyGrid map = drawn({2.0, 1.0, 0.1, {}}, 0.0);
  EXPECT_EQ(free_cells(map), 200);
  EXPECT_EQ(map.at(Eigen::Vector2d{0.05, 0.05}), CellState::Free);
  EXPECT_EQ(map.at(Eigen::Vector2d{-0.05, 0.5}), CellState::Occupied);
}

TEST(FloorPlan, ABoxTakesItsFloor) {
  const FloorPlan plan{2.0, 1.0, 0.1, {{{0.5, 0.0}, {0.7, 1.0}}}};
  EXPECT_EQ(free_cells(drawn(plan, 0.0)), 180);  // 2 of 20 columns gone
}

TEST(FloorPlan, ALowBoxIsNotInTheWayAboveIt) {
  const FloorPlan plan{2.0, 1.0, 0.1, {{{0.5, 0.0}, {0.7, 1.0}, 1.8}}};
  EXPECT_EQ(free_cells(drawn(plan, 2.0)), 200);
  EXPECT_EQ(free_cells(drawn(plan, 0.0)), 180);
}

TEST(FloorPlan, AWallAcrossHalvesWhatIsReached) {
  const FloorPlan plan{4.2, 2.0, 0.1, {{{2.0, 0.0}, {2.2, 2.0}}}};
  EXPECT_NEAR(reachable_share(drawn(plan, 0.0), {0.5, 1.0}, 0.3), 0.5, 1e-9);
  EXPECT_DOUBLE_EQ(reachable_share(drawn(plan, 0.0), {2.1, 1.0}, 0.3), 0.0);  // in the wall
}

}  // namespace
}  // namespace tandem::bench
