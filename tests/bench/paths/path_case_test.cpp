#include "bench/paths/path_case.hpp"

#include <gtest/gtest.h>

namespace tandem::bench {
namespace {

TEST(PathCase, LeadsAcrossHalfOfTheMap) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const PathCase one = path_case("S1u", seed);
    const double straight_m = (one.goal_in_map - one.start_in_map).norm();
    EXPECT_GE(straight_m, 0.5 * one.instance.plan.width_m) << "seed " << seed;
    EXPECT_GE(one.shortest_m, straight_m - 1e-9) << "seed " << seed;
    EXPECT_EQ(one.room.at(one.goal_in_map), CellState::Free) << "seed " << seed;
  }
}

TEST(PathCase, EqualSeedsGiveEqualCases) {
  const PathCase once = path_case("S1u", 2);
  const PathCase again = path_case("S1u", 2);
  EXPECT_EQ(once.goal_in_map, again.goal_in_map);
  EXPECT_EQ(once.shortest_m, again.shortest_m);
  EXPECT_NE(path_case("S1u", 3).goal_in_map, once.goal_in_map);
}

}  // namespace
}  // namespace tandem::bench
