#include "services/planner/core/srs/mental_model.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/sources.hpp"

namespace tandem {
namespace {

RewardWorld light_and_panel() {
  RewardWorld world =
      world_of({"a", "b"}, {disc_source("light", {2, 0}, 1, 1, 1), disc_source("panel", {5, 0}, 1, 1, 1)},
               {strict("light", "panel")});
  world.unawareness = {{"b", {"light"}}};
  return world;
}

TEST(MentalModel, WhatAnAgentDoesNotKnowHasNoRelationsForIt) {
  const RewardWorld known = world_as_known_by(light_and_panel(), "b");
  ASSERT_EQ(known.sources.size(), 1u);
  EXPECT_EQ(known.sources[0].id, "panel");
  EXPECT_TRUE(known.relations.empty());
  EXPECT_FALSE(problem_of(known));
  EXPECT_EQ(world_as_known_by(light_and_panel(), "a").sources.size(), 2u);
}

TEST(MentalModel, WhoIsToldKnows) {
  const RewardWorld world = light_and_panel();
  ASSERT_EQ(possible_informs(world), (std::vector<Inform>{{"b", "light"}}));

  const RewardWorld after = informed(world, {"b", "light"});
  EXPECT_TRUE(knows(after, "b", "light"));
  EXPECT_TRUE(possible_informs(after).empty());
  EXPECT_EQ(after.version, world.version + 1);
  EXPECT_EQ(world_as_known_by(after, "b").relations.size(), 1u);
}

TEST(MentalModel, WhatAnAgentDoesNotKnowItMayStillConsume) {
  Course course{light_and_panel()};
  EXPECT_DOUBLE_EQ(course.advance({absent(), stay_at({2, 0})}, 1.0)[1], 1.0);
}

}  // namespace
}  // namespace tandem
