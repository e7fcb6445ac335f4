#include "services/planner/core/team/search_world.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

SearchWorldOptions options(std::vector<Searcher> searchers) {
  SearchWorldOptions options;
  options.area = start_at(2, 2);
  options.searchers = std::move(searchers);
  return options;
}

TEST(SearchWorld, SearchersWhoDifferOnlyInNameShareWhatIsComputed) {
  Searcher other = test_person();
  other.id = "person2";
  SearchWorld world({empty_room(5, 5)}, options({test_person(), other, test_robot()}));
  EXPECT_EQ(&world.actions(0), &world.actions(1));
  EXPECT_NE(&world.actions(0), &world.actions(2));
}

TEST(SearchWorld, TheTimeOfASweepGrowsWithTheAreaAndFallsWithSpeed) {
  Searcher fast = test_person();
  fast.speed_mps *= 2.0;
  const double small_s = SearchWorld({empty_room(5, 5)}, options({test_person()})).sweep_time_s({0});
  SearchWorld large({empty_room(10, 10)}, options({test_person(), fast}));
  EXPECT_NEAR(large.sweep_time_s({0}), 4.0 * small_s, 0.1 * large.sweep_time_s({0}));
  EXPECT_NEAR(large.sweep_time_s({1}), 0.5 * large.sweep_time_s({0}), 1e-9);
}

TEST(SearchWorld, WhatIsBlockedForTheRobotIsNotForThePerson) {
  SearchWorld world({empty_room(10, 3)}, options({test_robot(), test_person()}));
  world.block(0, {{{5.5, 2}, 3.0}}, {2, 2});  // the whole width of the room
  const auto far_place = [](ActionSet& actions) {
    const int start = *actions.add_place({2, 2}, 0.5);
    const auto goal = actions.add_place({9.5, 2}, 0.5);
    return goal && actions.is_connected(start, *goal);
  };
  EXPECT_FALSE(far_place(world.actions(0)));
  EXPECT_TRUE(far_place(world.actions(1)));
}

TEST(SearchWorld, T10ADroneGoesOverALowWallAndAPersonAroundIt) {
  // The ground has a wall across with a gap at the far end; 2 m up there is none.
  std::vector<std::string> drawing(22, "#" + std::string(20, '.') + "#");
  drawing.front() = drawing.back() = std::string(22, '#');
  for (std::size_t row = 1; row < 18; ++row) drawing[row][10] = '#';
  Searcher drone = test_person();
  drone.layer = 1;
  SearchWorld world({room(drawing), empty_room(10, 10)}, options({test_person(), drone}));
  const auto way_m = [&](int searcher) {
    ActionSet& actions = world.actions(searcher);
    const int start = *actions.add_place({3, 8}, 0.5);
    const int goal = *actions.add_place({8, 8}, 0.5);
    return actions.leg(start, goal).duration_s * 0.75;
  };
  EXPECT_NEAR(way_m(1), 5.0, 0.1);
  EXPECT_GT(way_m(0), 13.0);
}

}  // namespace
}  // namespace tandem
