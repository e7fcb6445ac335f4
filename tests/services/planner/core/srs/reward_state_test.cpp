#include "services/planner/core/srs/reward_state.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/services/planner/support/sources.hpp"

namespace tandem {
namespace {

RewardWorld key_and_door(double door_pool) {
  return world_of({"a", "b"},
                  {disc_source("key", {0, 0}, 1.0, 1.0, 3.0),
                   disc_source("door", {5, 0}, 1.0, std::copysign(1.0, door_pool), door_pool)},
                  {strict("key", "door"), soft("key", "door", {"b"})});
}

TEST(RewardState, BeginsWithFullPoolsAndClosedGates) {
  const ResolvedWorld world{key_and_door(-7.0)};
  const RewardState state = initial_state(world);
  EXPECT_EQ(state.left, (std::vector<double>{3.0, 7.0}));
  EXPECT_EQ(state.drawn, (std::vector<double>{0.0, 0.0}));
  EXPECT_EQ(state.through, (std::vector<std::uint8_t>{0, 0}));
}

TEST(RewardState, AStrictRelationOpensForAllAndASoftOneSilencesWhomItNames) {
  const ResolvedWorld world{key_and_door(7.0)};
  RewardState state = initial_state(world);
  EXPECT_FALSE(is_opened(world.sources()[1], state));
  EXPECT_FALSE(is_silenced(world.sources()[0], 1, world, state));
  state.through = {1, 1};
  EXPECT_TRUE(is_opened(world.sources()[1], state));
  EXPECT_FALSE(is_silenced(world.sources()[0], 0, world, state));
  EXPECT_TRUE(is_silenced(world.sources()[0], 1, world, state));
}

TEST(RewardState, AnEditKeepsWhatHasGoneFromThePoolsThatStay) {
  const ResolvedWorld before{key_and_door(7.0)};
  RewardState state = initial_state(before);
  state.left = {0.0, 5.0};
  state.drawn = {3.0, 2.0};
  state.through = {1, 0};
  state.time_s = 12.0;

  RewardWorld edited = key_and_door(10.0);  // three more in the second pool
  edited.sources.insert(edited.sources.begin(), disc_source("new", {9, 9}, 1.0, 1.0, 4.0));
  const ResolvedWorld after{edited};
  const RewardState carried = carried_over(state, before, after);
  EXPECT_EQ(carried.left, (std::vector<double>{4.0, 0.0, 8.0}));
  EXPECT_EQ(carried.drawn, (std::vector<double>{0.0, 3.0, 2.0}));
  EXPECT_EQ(carried.through, state.through);
  EXPECT_DOUBLE_EQ(carried.time_s, 12.0);
}

TEST(RewardState, APoolMadeSmallerThanWhatHasGoneIsEmpty) {
  const ResolvedWorld before{key_and_door(7.0)};
  RewardState state = initial_state(before);
  state.left[1] = 1.0;
  state.drawn[1] = 6.0;
  EXPECT_EQ(carried_over(state, before, ResolvedWorld{key_and_door(5.0)}).left[1], 0.0);
}

TEST(RewardState, OnlyRewardOfThePoolsSignTakesFromIt) {
  const ResolvedWorld world{key_and_door(-7.0)};
  EXPECT_TRUE(takes_from(world.pools()[0], 1.0));
  EXPECT_FALSE(takes_from(world.pools()[0], -1.0));
  EXPECT_TRUE(takes_from(world.pools()[1], -1.0));
}

}  // namespace
}  // namespace tandem
