#include "services/planner/core/mission/mission_world.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "services/mapping/core/map_zones.hpp"
#include "services/mapping/core/ray_casting.hpp"
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

/// The least distance of `way` from the area [m].
double distance_m(const std::vector<Eigen::Vector2d>& way, const MapArea& area) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    for (int k = 0; k <= 100; ++k) {
      nearest_m = std::min(nearest_m, distance_to_area_m(area, way[i] + (way[i + 1] - way[i]) * k / 100.0));
    }
  }
  return nearest_m;
}

TEST(MissionWorld, TheRobotKeepsOutOfZonesAndSeesAcrossThemAndThePersonMindsThemNot) {
  const MapArea stairs{"stairs", {{4, 2}, {7, 2}, {7, 8}, {4, 8}}, AreaRule::KeepOut, 0.0};
  const OccupancyGrid hall = empty_room(10, 10);
  const auto options = search_world_options({}, "robot1", "person1", {2, 2});
  const auto world = search_world(hall, {stairs}, options);
  const auto ends_across = [&](int searcher) {
    ActionSet& actions = world->actions(searcher);
    const MotionMap& motion = actions.motion();
    const auto paths = motion.shortest_paths(*motion.nearest_node({2, 5}, 0.5));
    return motion.way(paths, *motion.nearest_node({9, 5}, 0.5), {2, 5}, {9, 5});
  };
  EXPECT_GT(distance_m(ends_across(0), stairs), 0.45) << "the robot's radius";
  EXPECT_EQ(distance_m(ends_across(1), stairs), 0.0);
  EXPECT_FALSE(world->actions(0).motion().nearest_node({5.5, 5}, 0.9));
  EXPECT_TRUE(line_of_sight(world->map(world->searcher(0).layer), {3, 5}, {8, 5}));
  EXPECT_EQ(world->area().size(), search_world(hall, {}, options)->area().size()) << "there is as much to be searched";
  EXPECT_EQ(search_world(hall, {}, options)->searcher(0).layer, 0);
}

}  // namespace
}  // namespace tandem
