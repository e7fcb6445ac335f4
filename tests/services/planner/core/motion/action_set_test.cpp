#include "services/planner/core/motion/action_set.hpp"

#include <gtest/gtest.h>

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
  ViewTable views{observability, robot};
  ActionSet actions{map, views, {}, {2.5, 2.5}};
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

TEST(ActionSet, ALegTakesAsLongAsItsWayAndShowsWhatIsSeenOnIt) {
  TwoRooms rooms;
  const int start = *rooms.actions.add_place({1.5, 2.5}, 0.5);
  const int goal = *rooms.actions.add_place({3.5, 2.5}, 0.5);
  const Leg& leg = rooms.actions.leg(start, goal);

  ASSERT_TRUE(leg.possible());
  EXPECT_DOUBLE_EQ(leg.duration_s, 4.0);  // 2 m at 0.5 m/s, from the very point to the very point
  EXPECT_DOUBLE_EQ(leg.initial_heading_rad, 0.0);
  ASSERT_GT(leg.seen.size(), 0U);
  EXPECT_DOUBLE_EQ(leg.seen.enter_s.front(), 0.0);
  for (const double leave_s : leg.seen.leave_s) EXPECT_LE(leave_s, 4.0);
}

TEST(ActionSet, ToStayIsNoLeg) {
  TwoRooms rooms;
  const int start = *rooms.actions.add_place({1.5, 2.5}, 0.5);
  EXPECT_FALSE(rooms.actions.leg(start, start).possible());
}

TEST(ActionSet, AGoalInAWallIsTheNearestPlaceWithinReachOrNone) {
  TwoRooms rooms;
  const auto place = rooms.actions.add_place({0.4, 2.5}, 1.0);
  ASSERT_TRUE(place);
  EXPECT_GT(rooms.actions.place(*place).x(), 0.5);
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
