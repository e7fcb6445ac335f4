#include "services/mapping/core/distance_field.hpp"

#include <gtest/gtest.h>

#include "services/common/random.hpp"
#include "tests/support/ascii_map.hpp"

namespace tandem {
namespace {

OccupancyGrid random_grid(Rng& rng, int width, int height, double share_occupied) {
  OccupancyGrid grid{width, height, 0.1, {1.0, -2.0, 0.3}, CellState::Free};
  for (CellState& cell : grid.cells()) {
    if (rng.uniform() < share_occupied) cell = CellState::Occupied;
  }
  return grid;
}

TEST(DistanceField, MeasuresToTheNearestWall) {
  const DistanceField field{test::ascii_map({".....", ".....", "#....", "....."}, 0.5)};

  EXPECT_FLOAT_EQ(field.at({0, 1}), 0.0F);
  EXPECT_FLOAT_EQ(field.at({2, 1}), 1.0F);
  EXPECT_FLOAT_EQ(field.at({3, 1}), 1.5F);
  EXPECT_NEAR(field.at({1, 2}), std::sqrt(0.5), 1e-6);  // half a metre along, half a metre up
}

TEST(DistanceField, IsExact) {
  Rng rng{3};
  for (int trial = 0; trial < 20; ++trial) {
    const OccupancyGrid grid = random_grid(rng, 17, 23, 0.03);
    const DistanceField field{grid, 1.0};
    for (int row = 0; row < grid.height(); ++row) {
      for (int column = 0; column < grid.width(); ++column) {
        double nearest = 1.0;
        for (int r = 0; r < grid.height(); ++r) {
          for (int c = 0; c < grid.width(); ++c) {
            if (grid.is_occupied({c, r})) nearest = std::min(nearest, 0.1 * std::hypot(c - column, r - row));
          }
        }
        ASSERT_NEAR(field.at({column, row}), nearest, 1e-5) << "trial " << trial;
      }
    }
  }
}

TEST(DistanceField, CountsUnknownCellsWhereAsked) {
  const OccupancyGrid room = test::ascii_map({"?...#"});

  EXPECT_FLOAT_EQ(DistanceField(room).at({1, 0}), 3.0F);
  EXPECT_FLOAT_EQ(DistanceField(room, 100.0, Obstacles::OccupiedOrUnknown).at({1, 0}), 1.0F);
}

TEST(DistanceField, IsTheCutOffWhereNothingIsOccupied) {
  EXPECT_FLOAT_EQ(DistanceField(test::ascii_map({"..", ".."}), 2.5).at({1, 1}), 2.5F);
}

TEST(DistanceField, InterpolatesBetweenCentres) {
  const DistanceField field{test::ascii_map({"#...."})};

  EXPECT_DOUBLE_EQ(field.distance_m({2.5, 0.5}), 2.0);    // on a centre
  EXPECT_DOUBLE_EQ(field.distance_m({2.75, 0.5}), 2.25);  // a quarter of a cell on
  EXPECT_NEAR(field.smooth({2.75, 0.5}).distance_m, 2.25, 1e-12);
  EXPECT_NEAR(field.smooth({2.75, 0.5}).gradient_in_map.x(), 1.0, 1e-12);
}

TEST(DistanceField, HasTheGradientThatDifferencesHave) {
  Rng rng{5};
  const OccupancyGrid grid = random_grid(rng, 40, 40, 0.02);
  const DistanceField field{grid, 1.0};
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector2d p = grid.map_from_grid() * Eigen::Vector2d{rng.uniform(0.2, 3.8), rng.uniform(0.2, 3.8)};
    const DistanceAndGradient here = field.smooth(p);
    const Eigen::Vector2d dx{kStep, 0.0};
    const Eigen::Vector2d dy{0.0, kStep};
    const double along_x = (field.smooth(p + dx).distance_m - field.smooth(p - dx).distance_m) / (2.0 * kStep);
    const double along_y = (field.smooth(p + dy).distance_m - field.smooth(p - dy).distance_m) / (2.0 * kStep);
    ASSERT_NEAR(here.gradient_in_map.x(), along_x, 1e-4);
    ASSERT_NEAR(here.gradient_in_map.y(), along_y, 1e-4);
  }
}

TEST(DistanceField, HoldsItsBorderValueOutside) {
  const DistanceField field{test::ascii_map({"#...."})};

  EXPECT_DOUBLE_EQ(field.distance_m({100.0, 0.5}), 4.0);
  EXPECT_DOUBLE_EQ(field.smooth({100.0, 7.0}).distance_m, 4.0);
  EXPECT_FLOAT_EQ(field.nearest({-100.0, 0.5}), 0.0F);
}

}  // namespace
}  // namespace tandem
