#include "services/planner/core/search/search_area.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

TEST(SearchArea, CoversTheFloorThatCanBeWalkedTo) {
  // Two rooms of 2 m x 2 m with a wall between them.
  const OccupancyGrid map = room({"##########", "#....#...#", "#....#...#", "#....#...#", "#....#...#", "##########"});
  const SearchArea area(map, start_at(1.5, 1.5));

  EXPECT_NEAR(area.area_m2(), 4.0, 0.3);
  EXPECT_TRUE(area.cell_at({1.5, 1.5}));
  EXPECT_FALSE(area.cell_at({3.8, 1.5}));
  EXPECT_FALSE(area.cell_at({-100.0, 1e9}));
}

TEST(SearchArea, StaysInsideItsOutline) {
  const OccupancyGrid map = empty_room(10, 10);
  SearchAreaOptions options = start_at(2, 2);
  options.outline_in_map = {{0, 0}, {5.5, 0}, {5.5, 11}, {0, 11}};

  EXPECT_NEAR(SearchArea(map, options).area_m2(), 50.0, 1.5);
}

TEST(UniformPrior, LeavesOutTheSurroundingsOfTheStart) {
  const OccupancyGrid map = empty_room(10, 4);
  const SearchArea area(map, start_at(1, 1));
  const auto prior = uniform_prior(area, {1, 1}, 3.0);

  EXPECT_NEAR(std::accumulate(prior.begin(), prior.end(), 0.0), 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(prior[static_cast<std::size_t>(*area.cell_at({1.2, 1.2}))], 0.0);
}

}  // namespace
}  // namespace tandem
