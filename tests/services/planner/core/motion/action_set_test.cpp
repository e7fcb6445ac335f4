#include "services/planner/core/motion/action_set.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/services/planner/support/room.hpp"

namespace tandem {
namespace {

/// Two rooms of 4 m x 4 m with a door between them; a robot of 0.5 m/s and 0.5 rad/s stands in the left one.
struct TwoRooms {
  OccupancyGrid map = room({"###################", "#........#........#", "#........#........#", "#........#........#",
                            "#.................#", "#.................#", "#........#........#", "#........#........#",
                            "#........#........#", "###################"});
  SearchArea area{map, {.start_in_map = {2.5, 2.5}, .outline_in_map = {}}};
  Observability observability{map, area, 5.0};
  Searcher robot{.id = "robot", .speed_mps = 0.5, .turn_rate_radps = 0.5, .field_of_view_rad = 1.0};
  ActionSet actions{map, observability, robot, {}, {2.5, 2.5}};
};

TEST(ActionSet, HasLookoutsInBothRooms) {
  TwoRooms rooms;
  bool left = false;
  bool right = false;
  for (int i = 0; i < rooms.actions.lookouts(); ++i) {
    left = left || rooms.actions.place(i).x() < 4.5;
    right = right || rooms.actions.place(i).x() > 5.0;
  }
  EXPECT_TRUE(left);
  EXPECT_TRUE(right);
}

TEST(ActionSet, ALegTakesAsManyStepsAsItsWayIsLong) {
  TwoRooms rooms;
  const int start = *rooms.actions.add_place({1.5, 2.5}, 0.5);
  const int goal = *rooms.actions.add_place({3.5, 2.5}, 0.5);
  const Leg& leg = rooms.actions.leg(start, goal);

  ASSERT_TRUE(leg.possible());
  EXPECT_NEAR(leg.steps() * rooms.actions.step_s(), 4.0, 0.5);  // 2 m at 0.5 m/s
  EXPECT_NEAR(leg.initial_heading_rad, 0.0, 0.1);
  for (const Look& look : leg.looks) {
    EXPECT_GT(look.probability, 0.0);
    EXPECT_LE(look.probability, 1.0);
  }
}

TEST(ActionSet, TurningTakesTheStepsOfTheShorterTurn) {
  const TwoRooms rooms;
  EXPECT_EQ(rooms.actions.turning_steps(0.0, 0.0), 0);
  EXPECT_EQ(rooms.actions.turning_steps(0.0, 1.0), 4);  // 1 rad at 0.5 rad/s is 2 s of 0.5 s
  EXPECT_EQ(rooms.actions.turning_steps(std::numbers::pi - 0.5, -std::numbers::pi + 0.5), 4);
}

TEST(ActionSet, AGoalInAWallIsTheNearestPlaceWithinReachOrNone) {
  TwoRooms rooms;
  EXPECT_TRUE(rooms.actions.add_place({0.4, 2.5}, 1.0));
  EXPECT_FALSE(rooms.actions.add_place({-20.0, 2.5}, 1.0));
}

TEST(ActionSet, ForgetsAddedPlacesButNotItsLookouts) {
  TwoRooms rooms;
  const int lookouts = rooms.actions.lookouts();
  const int added = *rooms.actions.add_place({2.5, 2.5}, 0.5);
  EXPECT_EQ(added, lookouts);
  rooms.actions.forget_added_places();
  EXPECT_EQ(*rooms.actions.add_place({3.5, 3.5}, 0.5), lookouts);
}

}  // namespace
}  // namespace tandem
