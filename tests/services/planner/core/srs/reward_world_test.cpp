#include "services/planner/core/srs/reward_world.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/sources.hpp"

namespace tandem {
namespace {

TEST(RewardWorld, RefusesACircleOfStrictRelations) {
  RewardWorld world{{disc_source("a", {0, 0}, 1, 1), disc_source("b", {0, 0}, 1, 1)}, {}};
  world.relations.push_back({RelationKind::Strict, "a", "b", 1.0, {}});
  EXPECT_FALSE(problem_of(world));
  world.relations.push_back({RelationKind::Strict, "b", "a", 1.0, {}});
  EXPECT_TRUE(problem_of(world));
}

}  // namespace
}  // namespace tandem
