#include "bench/paths/shortest_way.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "services/common/random.hpp"
#include "services/mapping/core/ray_casting.hpp"

namespace tandem::bench {
namespace {

constexpr double kHairs_m = 1e-3;

OccupancyGrid room(int width, int height) {
  return OccupancyGrid{width, height, 1.0, {}, CellState::Free};
}

TEST(ShortestWay, IsStraightWhereNothingStandsInTheWay) {
  const auto way = shortest_way(room(10, 10), {1.5, 1.5}, {4.5, 5.5});
  ASSERT_TRUE(way);
  EXPECT_EQ(way->size(), 2U);
  EXPECT_DOUBLE_EQ(length_m(*way), 5.0);  // 3, 4, 5
}

TEST(ShortestWay, TurnsAtTheCornersOfABlock) {
  OccupancyGrid grid = room(12, 10);
  for (int row = 0; row < 5; ++row) grid.set({5, row}, CellState::Occupied);  // x in [5, 6], up to y = 5
  const auto way = shortest_way(grid, {2.0, 1.0}, {9.0, 1.0});
  ASSERT_TRUE(way);
  EXPECT_EQ(way->size(), 4U);
  EXPECT_NEAR(length_m(*way), 5.0 + 1.0 + 5.0, kHairs_m);  // 3, 4, 5 to each side
}

TEST(ShortestWay, IsNoneWhereAWallHasNoGap) {
  OccupancyGrid grid = room(9, 9);
  for (int row = 0; row < 9; ++row) grid.set({4, row}, CellState::Occupied);
  EXPECT_FALSE(shortest_way(grid, {1.5, 1.5}, {7.5, 1.5}));
  // Nor is a gap what is between two cells that touch at a corner.
  OccupancyGrid stairs = room(4, 4);
  for (int i = 0; i < 4; ++i) stairs.set({i, i}, CellState::Occupied);
  EXPECT_FALSE(shortest_way(stairs, {2.5, 0.5}, {0.5, 2.5}));
}

TEST(ShortestWay, IsNoLongerThanAnyWayOverTheGrid) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Rng rng{seed};
    OccupancyGrid grid = room(20, 20);
    for (int block = 0; block < 60; ++block) {
      grid.set({static_cast<int>(rng.index(20)), static_cast<int>(rng.index(20))}, CellState::Occupied);
    }
    grid.set({0, 0}, CellState::Free);
    grid.set({19, 19}, CellState::Free);
    const auto way = shortest_way(grid, {0.5, 0.5}, {19.5, 19.5});
    // Over cells and their eight neighbours, again and again until nothing gets shorter.
    std::vector<double> cost_m(400, 1e9);
    cost_m[0] = 0.0;
    for (bool changed = true; changed;) {
      changed = false;
      for (int cell = 0; cell < 400; ++cell) {
        const CellIndex here{cell % 20, cell / 20};
        for (const CellIndex step : {CellIndex{1, 0}, {0, 1}, {1, 1}, {-1, 1}, {-1, 0}, {0, -1}, {-1, -1}, {1, -1}}) {
          const CellIndex there{here.column + step.column, here.row + step.row};
          if (!grid.contains(there)) continue;
          const Eigen::Vector2d from = grid.centre_in_map(there);
          const double by_there_m = cost_m[grid.offset(there)] + (grid.centre_in_map(here) - from).norm();
          if (by_there_m >= cost_m[grid.offset(here)] || !line_of_sight(grid, from, grid.centre_in_map(here))) continue;
          cost_m[grid.offset(here)] = by_there_m;
          changed = true;
        }
      }
    }
    ASSERT_EQ(way.has_value(), cost_m[399] < 1e9) << "seed " << seed;
    if (!way) continue;
    EXPECT_LE(length_m(*way), cost_m[399] + kHairs_m) << "seed " << seed;
    for (std::size_t i = 1; i < way->size(); ++i) EXPECT_TRUE(line_of_sight(grid, (*way)[i - 1], (*way)[i]));
  }
}

TEST(ShortestWay, ABodyKeepsItsRadiusFromWalls) {
  OccupancyGrid grid{9, 9, 0.1, {}, CellState::Free};
  grid.set({4, 4}, CellState::Occupied);
  const OccupancyGrid middle = room_for(grid, 0.3);
  EXPECT_TRUE(middle.is_occupied({2, 4}));  // 0.2 m from it
  EXPECT_TRUE(middle.is_free({1, 4}));      // 0.3 m
  EXPECT_TRUE(middle.is_free({2, 2}));      // 0.283 m, within what is allowed between cells
}

}  // namespace
}  // namespace tandem::bench
