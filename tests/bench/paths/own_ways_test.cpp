#include "bench/paths/own_ways.hpp"

#include <gtest/gtest.h>

namespace tandem::bench {
namespace {

TEST(OwnWays, AreNearlyShortestWithoutClearanceAndNeverShorter) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto records = own_ways(path_case("S1u", seed));
    ASSERT_EQ(records.size(), 4U);
    for (const PathRecord& record : records) {
      EXPECT_GE(record.length_m, 0.995 * record.shortest_m) << record.planner << ", seed " << seed;
      EXPECT_LE(record.length_m, 1.25 * record.shortest_m) << record.planner << ", seed " << seed;
    }
    EXPECT_LE(records[0].length_m, 1.08 * records[0].shortest_m) << "seed " << seed;  // an octagon's worst
  }
}

}  // namespace
}  // namespace tandem::bench
