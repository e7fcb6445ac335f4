#include "services/planner/core/mission/team_world.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/room.hpp"

namespace tandem {
namespace {

TEST(TeamWorld, IsLimitedToTheOutlineOfTheConfig) {
  PlannerConfig config;
  const TeamWorld whole(empty_room(10, 10), config, "robot1", "person1", {2, 2});
  config.area_in_map_m = {0, 0, 5.5, 0, 5.5, 11, 0, 11};
  const TeamWorld half(empty_room(10, 10), config, "robot1", "person1", {2, 2});

  EXPECT_NEAR(whole.area().area_m2(), 100.0, 1.0);
  EXPECT_NEAR(half.area().area_m2(), 50.0, 1.5);
}

TEST(TeamWorld, TheTimeOfASweepGrowsWithTheAreaAndFallsWithSpeed) {
  PlannerConfig config;
  const double small_s = TeamWorld(empty_room(5, 5), config, "r", "p", {2, 2}).sweep_time_s();
  const double large_s = TeamWorld(empty_room(10, 10), config, "r", "p", {2, 2}).sweep_time_s();
  EXPECT_NEAR(large_s, 4.0 * small_s, 0.1 * large_s);
  config.robot_speed_mps *= 2.0;
  config.person_speed_mps *= 2.0;
  EXPECT_NEAR(TeamWorld(empty_room(10, 10), config, "r", "p", {2, 2}).sweep_time_s(), 0.5 * large_s, 1e-9);
}

TEST(TeamWorld, WhatIsBlockedForTheRobotIsNotForThePerson) {
  TeamWorld world(empty_room(10, 3), {}, "robot1", "person1", {2, 2});
  world.block({{{5.5, 2}, 3.0}}, {2, 2});  // the whole width of the room
  const auto far_place = [](ActionSet& actions) {
    const int start = *actions.add_place({2, 2}, 0.5);
    const auto goal = actions.add_place({9.5, 2}, 0.5);
    return goal && actions.is_connected(start, *goal);
  };
  EXPECT_FALSE(far_place(world.robot()));
  EXPECT_TRUE(far_place(world.person()));
  EXPECT_EQ(world.robot().searcher().id, "robot1");
}

}  // namespace
}  // namespace tandem
