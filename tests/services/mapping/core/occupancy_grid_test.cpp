#include "services/mapping/core/occupancy_grid.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "services/common/random.hpp"
#include "tests/support/ascii_map.hpp"

namespace tandem {
namespace {

TEST(OccupancyGrid, CountsColumnsAlongXAndRowsAlongYFromTheLowerLeft) {
  const OccupancyGrid room = test::ascii_map({"#..", "?.#"}, 0.5);

  EXPECT_EQ(room.at(CellIndex{0, 1}), CellState::Occupied);
  EXPECT_EQ(room.at(CellIndex{0, 0}), CellState::Unknown);
  EXPECT_EQ(room.at(Eigen::Vector2d{1.25, 0.25}), CellState::Occupied);
  EXPECT_EQ(room.at(Eigen::Vector2d{0.75, 0.75}), CellState::Free);
}

TEST(OccupancyGrid, IsUnknownOutside) {
  const OccupancyGrid room = test::ascii_map({"##", "##"});

  EXPECT_EQ(room.at(Eigen::Vector2d{-0.001, 0.5}), CellState::Unknown);
  EXPECT_EQ(room.at(Eigen::Vector2d{2.0, 0.5}), CellState::Unknown);
  EXPECT_EQ(room.at(Eigen::Vector2d{1e300, -1e300}), CellState::Unknown);
}

TEST(OccupancyGrid, LiesWhereItsOriginSays) {
  // A quarter turn: the grid's x axis points along the map's y axis.
  const OccupancyGrid room = test::ascii_map({"..#"}, 1.0, {10.0, 20.0, std::numbers::pi / 2.0});

  EXPECT_EQ(room.at(Eigen::Vector2d{9.5, 22.5}), CellState::Occupied);
  EXPECT_EQ(room.at(Eigen::Vector2d{9.5, 20.5}), CellState::Free);
}

TEST(OccupancyGrid, FindsTheCellOfEveryCentre) {
  Rng rng{11};
  for (int i = 0; i < 200; ++i) {
    const OccupancyGrid grid{
        40, 30, rng.uniform(0.01, 2.0), {rng.uniform(-50, 50), rng.uniform(-50, 50), rng.uniform(-3, 3)}};
    const CellIndex cell{static_cast<int>(rng.index(40)), static_cast<int>(rng.index(30))};
    EXPECT_EQ(grid.cell_at(grid.centre_in_map(cell)), cell);
  }
}

}  // namespace
}  // namespace tandem
