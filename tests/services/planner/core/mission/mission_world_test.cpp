#include "services/planner/core/mission/mission_world.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/room.hpp"

namespace tandem {
namespace {

TEST(MissionWorld, IsLimitedToTheOutlineOfTheConfig) {
  PlannerConfig config;
  const SearchWorld whole({empty_room(10, 10)}, search_world_options(config, "robot1", "person1", {2, 2}));
  config.area_in_map_m = {0, 0, 5.5, 0, 5.5, 11, 0, 11};
  const SearchWorld half({empty_room(10, 10)}, search_world_options(config, "robot1", "person1", {2, 2}));

  EXPECT_NEAR(whole.area().area_m2(), 100.0, 1.0);
  EXPECT_NEAR(half.area().area_m2(), 50.0, 1.5);
}

TEST(MissionWorld, TheRobotIsTheFirstSearcher) {
  const auto options = search_world_options({}, "robot1", "person1", {2, 2});
  EXPECT_EQ(options.searchers[0].id, "robot1");
  EXPECT_EQ(options.searchers[1].id, "person1");
}

}  // namespace
}  // namespace tandem
