#include "services/mapping/core/ray_casting.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "services/common/random.hpp"
#include "tests/support/ascii_map.hpp"

namespace tandem {
namespace {

constexpr double kPi = std::numbers::pi;

OccupancyGrid room() {
  return test::ascii_map({
      "#######",
      "#.....#",
      "#..#..#",
      "#.....#",
      "#######",
  });
}

TEST(RayCasting, StopsWhereItEntersTheWall) {
  EXPECT_NEAR(range_to_obstacle_m(room(), {1.5, 1.5}, 0.0, 10.0).value(), 4.5, 1e-12);  // wall from x = 6
  EXPECT_NEAR(range_to_obstacle_m(room(), {1.5, 1.5}, kPi, 10.0).value(), 0.5, 1e-12);  // wall up to x = 1
  EXPECT_NEAR(range_to_obstacle_m(room(), {1.5, 2.5}, 0.0, 10.0).value(), 1.5, 1e-12);  // pillar from x = 3
  EXPECT_NEAR(range_to_obstacle_m(room(), {1.5, 1.5}, kPi / 2.0, 10.0).value(), 2.5, 1e-12);
}

TEST(RayCasting, FindsNothingBeyondItsRange) {
  EXPECT_FALSE(range_to_obstacle_m(room(), {1.5, 1.5}, 0.0, 4.4).has_value());
  EXPECT_TRUE(range_to_obstacle_m(room(), {1.5, 1.5}, 0.0, 4.6).has_value());
}

TEST(RayCasting, SeesTheGridFromOutside) {
  EXPECT_NEAR(range_to_obstacle_m(room(), {-3.0, 2.5}, 0.0, 10.0).value(), 3.0, 1e-12);
  EXPECT_FALSE(range_to_obstacle_m(room(), {-3.0, 2.5}, kPi, 10.0).has_value());
  EXPECT_FALSE(range_to_obstacle_m(room(), {-3.0, 7.5}, 0.0, 20.0).has_value());
}

TEST(RayCasting, IsZeroInsideAWall) {
  EXPECT_DOUBLE_EQ(range_to_obstacle_m(room(), {3.5, 2.5}, 1.0, 10.0).value(), 0.0);
}

TEST(RayCasting, AgreesWithSmallSteps) {
  Rng rng{21};
  OccupancyGrid grid{30, 20, 0.2, {-1.0, 4.0, 0.7}, CellState::Free};
  for (CellState& cell : grid.cells()) {
    if (rng.uniform() < 0.05) cell = CellState::Occupied;
  }
  for (int trial = 0; trial < 300; ++trial) {
    const Eigen::Vector2d origin =
        grid.map_from_grid() * Eigen::Vector2d{rng.uniform(-1.0, 7.0), rng.uniform(-1.0, 5.0)};
    const double heading = rng.uniform(-kPi, kPi);
    const Eigen::Vector2d direction{std::cos(heading), std::sin(heading)};
    constexpr double kStep = 1e-3;
    double expected = 5.0;
    for (double length = 0.0; length < 5.0; length += kStep) {
      if (grid.at(Eigen::Vector2d{origin + length * direction}) == CellState::Occupied) {
        expected = length;
        break;
      }
    }
    // Small steps can jump over a corner, never find a wall before its edge.
    const double found = range_to_obstacle_m(grid, origin, heading, 5.0).value_or(5.0);
    ASSERT_LE(found, expected + 1e-9) << "trial " << trial;
    if (found < expected - 2.0 * kStep) {
      const Eigen::Vector2d just_inside = grid.in_cells(origin + (found + 1e-9) * direction);
      const Eigen::Vector2d to_corner = just_inside - just_inside.array().round().matrix();
      ASSERT_LT(to_corner.norm(), 0.02) << "trial " << trial;
    }
  }
}

TEST(LineOfSight, IsBlockedByAPillarAlone) {
  EXPECT_TRUE(line_of_sight(room(), {1.5, 1.5}, {5.5, 1.5}));
  EXPECT_FALSE(line_of_sight(room(), {1.5, 2.5}, {5.5, 2.5}));
  EXPECT_TRUE(line_of_sight(room(), {1.5, 2.5}, {2.9, 2.5}));
  EXPECT_TRUE(line_of_sight(room(), {1.5, 2.5}, {1.5, 2.5}));
}

TEST(LineOfSight, IsTheSameBothWays) {
  Rng rng{9};
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector2d a{rng.uniform(0.0, 7.0), rng.uniform(0.0, 5.0)};
    const Eigen::Vector2d b{rng.uniform(0.0, 7.0), rng.uniform(0.0, 5.0)};
    EXPECT_EQ(line_of_sight(room(), a, b), line_of_sight(room(), b, a));
  }
}

}  // namespace
}  // namespace tandem
