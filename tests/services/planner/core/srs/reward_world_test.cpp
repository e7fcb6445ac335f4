#include "services/planner/core/srs/reward_world.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/sources.hpp"

namespace tandem {
namespace {

TEST(RewardWorld, NamesACircleOfStrictRelations) {
  RewardWorld world = world_of({"x"}, {disc_source("a", {0, 0}, 1, 1, 1), disc_source("b", {0, 0}, 1, 1, 1)});
  EXPECT_FALSE(add_relation(world, strict("a", "b")));
  const auto problem = add_relation(world, strict("b", "a"));

  ASSERT_TRUE(problem);
  EXPECT_NE(problem->what.find("a => b => a"), std::string::npos) << problem->what;
  EXPECT_EQ(world.relations.size(), 1u);
}

}  // namespace
}  // namespace tandem
