#include "services/planner/core/search/observability.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

TEST(Observability, WallsBlockTheView) {
  const OccupancyGrid map = room({"##########", "#...#....#", "#...#....#", "#........#", "##########"});
  const SearchArea area(map, start_at(0.75, 0.75));
  Observability sight(map, area, 4.0);
  const auto& seen = sight.in_sight_of(*area.cell_at({0.75, 1.75}));

  EXPECT_NE(std::ranges::find(seen, *area.cell_at({0.75, 0.75})), seen.end());
  EXPECT_EQ(std::ranges::find(seen, *area.cell_at({4.2, 1.75})), seen.end());
}

TEST(Observability, SeesOnlyInRangeAndInTheFieldOfView) {
  const OccupancyGrid map = empty_room(10, 10);
  const SearchArea area(map, start_at(5, 5));
  Observability sight(map, area, 4.0);
  const View seen = sight.seen_from(test_robot(), {5.25, 5.25, 0.0});
  const auto sees = [&](double x, double y) { return std::ranges::find(seen, *area.cell_at({x, y})) != seen.end(); };

  EXPECT_TRUE(sees(7.25, 5.25));   // 2 m ahead
  EXPECT_FALSE(sees(5.5, 5.25));   // nearer than the camera sees the floor
  EXPECT_FALSE(sees(9.75, 5.25));  // 4.5 m
  EXPECT_FALSE(sees(5.25, 7.25));  // to the left
  EXPECT_TRUE(sees(7.25, 6.25));   // 26.6 degrees
  EXPECT_FALSE(sees(7.25, 6.75));  // 36.9 degrees: a 3-4-5 triangle
}

}  // namespace
}  // namespace tandem
