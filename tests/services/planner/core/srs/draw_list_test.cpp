#include "services/planner/core/srs/draw_list.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/sources.hpp"

namespace tandem {
namespace {

/// A joint move in a world, looked at from its begin.
struct Scene {
  Scene(RewardWorld given, std::vector<AgentMove> agents, double duration_s)
      : world(std::move(given)), moves(std::move(agents)), joint{moves, duration_s} {
    draws.begin_move(world, state, joint);
  }
  void look_at(double from_share, double to_share) {
    draws.begin_part(world, joint, from_share, to_share);
    draws.begin_step(world, state);
  }

  ResolvedWorld world;
  RewardState state = initial_state(world);
  std::vector<AgentMove> moves;
  JointMove joint;
  DrawList draws;
};

TEST(DrawList, AMoveIsCutWhereItEntersAndLeaves) {
  Scene scene{world_of({"a"}, {disc_source("s", {0, 0}, 2.0, 1.0)}), {straight_move({-4, 0}, {4, 0})}, 8.0};
  ASSERT_EQ(scene.draws.shares().size(), 4u);
  EXPECT_NEAR(scene.draws.shares()[1], 0.25, 1e-12);
  EXPECT_NEAR(scene.draws.shares()[2], 0.75, 1e-12);

  scene.look_at(0.0, 0.25);
  EXPECT_TRUE(scene.draws.draws().empty());
  scene.look_at(0.25, 0.75);
  ASSERT_EQ(scene.draws.draws().size(), 1u);
  EXPECT_DOUBLE_EQ(scene.draws.draws()[0].per_s, 1.0);
}

TEST(DrawList, WhoPassesByIsNoContact) {
  Scene scene{world_of({"a"}, {disc_source("s", {0, 0}, 2.0, 1.0)}), {straight_move({-4, 3}, {4, 3})}, 8.0};
  EXPECT_TRUE(scene.draws.contacts().empty());
}

TEST(DrawList, OfAGroupTheStrongestDraws) {
  RewardWorld world = world_of({"a"}, {disc_source("weak", {0, 0}, 3.0, 1.0), disc_source("strong", {0, 0}, 1.0, 4.0)});
  world.groups.push_back({"object", {"weak", "strong"}, 10.0});
  Scene scene{world, {stay_at({0, 0})}, 1.0};
  scene.look_at(0.0, 1.0);
  ASSERT_EQ(scene.draws.draws().size(), 1u);
  EXPECT_EQ(scene.draws.draws()[0].source, 1u);
  EXPECT_DOUBLE_EQ(scene.draws.outflow_per_s(scene.draws.draws()[0].pool), 4.0);
}

TEST(DrawList, AStepEndsWhereThePoolOfTwoRunsDry) {
  Scene scene{world_of({"a", "b"}, {disc_source("s", {0, 0}, 1.0, 2.0, 6.0)}), {stay_at({0, 0}), stay_at({0, 0})}, 5.0};
  scene.look_at(0.0, 1.0);
  const DrawList::Step step = scene.draws.longest_step(scene.world, scene.state, scene.joint, 0.0, 5.0);
  EXPECT_DOUBLE_EQ(step.length_s, 1.5);
  EXPECT_EQ(step.ended_by, 0u);
  EXPECT_DOUBLE_EQ(step.amount, 6.0);
}

TEST(DrawList, ACodependentPoolIsDrawnFromByWhoDrawsFromTheOther) {
  Scene scene{world_of({"a"}, {disc_source("x", {0, 0}, 1.0, 1.0, 9.0), disc_source("y", {9, 0}, 1.0, 1.0, 2.0)},
                       {codependent("x", "y", 0.5)}),
              {stay_at({0, 0})},
              9.0};
  scene.look_at(0.0, 1.0);
  EXPECT_EQ(scene.draws.pools(), (std::vector<std::size_t>{0, 1}));
  const DrawList::Step step = scene.draws.longest_step(scene.world, scene.state, scene.joint, 0.0, 9.0);
  EXPECT_DOUBLE_EQ(step.length_s, 4.0);  // y loses 0.5 a second
  EXPECT_EQ(step.ended_by, 1u);
}

TEST(DrawList, AClosedSourceIsTouchedButNotDrawnFrom) {
  Scene scene{world_of({"a"}, {disc_source("key", {9, 0}, 1.0, 1.0, 1.0), disc_source("door", {0, 0}, 1.0, 1.0, 1.0)},
                       {strict("key", "door")}),
              {stay_at({0, 0})},
              1.0};
  scene.look_at(0.0, 1.0);
  ASSERT_EQ(scene.draws.contacts().size(), 1u);
  EXPECT_FALSE(scene.draws.contacts()[0].open);
  EXPECT_TRUE(scene.draws.draws().empty());
}

}  // namespace
}  // namespace tandem
