#include "services/planner/core/motion/lookouts.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/services/planner/support/room.hpp"

namespace tandem {
namespace {

TEST(CoveringLookouts, TogetherSeeNearlyEverything) {
  const OccupancyGrid map = room({"################", "#......#.......#", "#......#.......#", "#..............#",
                                  "#......#.......#", "#......#.......#", "################"},
                                 1.0);
  SearchAreaOptions options;
  options.start_in_map = {2, 3};
  const SearchArea area(map, options);
  Observability sight(map, area, 4.0);
  const MotionMap motion(map, {});
  const auto lookouts = covering_lookouts(sight, motion, *motion.nearest_node({2, 3}, 1.0), 3.0, 0.5);

  std::vector<bool> seen(static_cast<std::size_t>(area.size()), false);
  for (const int node : lookouts) {
    for (const int cell : sight.in_sight_of(*area.nearest_cell(motion.point(node), 0.5))) {
      seen[static_cast<std::size_t>(cell)] = true;
    }
  }
  EXPECT_GE(lookouts.size(), 4U);
  EXPECT_LE(lookouts.size(), 12U);
  EXPECT_GE(std::count(seen.begin(), seen.end(), true), 0.97 * area.size());
}

}  // namespace
}  // namespace tandem
