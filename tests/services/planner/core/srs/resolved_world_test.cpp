#include "services/planner/core/srs/resolved_world.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/sources.hpp"

namespace tandem {
namespace {

TEST(ResolvedWorld, MembersOfAGroupShareAPool) {
  RewardWorld world = world_of(
      {"x"}, {disc_source("a", {0, 0}, 1, 1), disc_source("b", {0, 0}, 1, 1, 2), disc_source("c", {0, 0}, 1, 1)});
  world.groups = {{"g", {"c", "a"}, 5.0}};
  const ResolvedWorld ready{world};
  EXPECT_EQ(ready.sources()[0].pool, ready.sources()[2].pool);
  EXPECT_NE(ready.sources()[0].pool, ready.sources()[1].pool);
  EXPECT_DOUBLE_EQ(ready.pools()[ready.sources()[0].pool].size, 5.0);
}

TEST(ResolvedWorld, ARateIsPaceTimesWorthTimesTheRatio) {
  RewardSource source = disc_source("s", {0, 0}, 1, 2.0);
  source.targets = {"x"};
  source.tempers = {{"x", 3.0, 0.5}};
  const ResolvedWorld ready{world_of({"x", "y"}, {source})};
  const std::vector<AgentMove> moves{straight_move({0, 0}, {4, 0}), stay_at({0, 0})};
  EXPECT_DOUBLE_EQ(rate_of(ready.sources()[0], 0, {moves, 1.0}, 0.25), 3.0);  // on the boundary
  EXPECT_DOUBLE_EQ(rate_of(ready.sources()[0], 0, {moves, 1.0}, 0.5), 0.0);
  EXPECT_DOUBLE_EQ(rate_of(ready.sources()[0], 1, {moves, 1.0}, 0.0), 0.0);  // no target
  EXPECT_DOUBLE_EQ(peak_rate_of(ready.sources()[0], 0), 3.0);
}

}  // namespace
}  // namespace tandem
