#include "services/planner/core/tasks/travel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/services/planner/support/room.hpp"
#include "tests/services/planner/support/tasks.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

Searcher walker() {
  return task_agent("a", 0.0, 0.0).searcher;
}

TEST(Travel, GoesStraightOnAnOpenPlane) {
  const ResolvedWorld world{world_of({"a"}, {})};
  const Hazards hazards{world, 0, 0.0};
  Travel travel{nullptr, &hazards, walker(), 0.0};
  const int from = *travel.place_at({0.0, 0.0}, 0.5);
  const int to = *travel.place_at({3.0, 4.0}, 0.5);
  ASSERT_EQ(travel.ways(from, to).size(), 1U);
  EXPECT_DOUBLE_EQ(travel.ways(from, to).front().length_m, 5.0);
  EXPECT_EQ(travel.place_at({3.0, 4.0}, 0.5), to);
}

TEST(Travel, OffersTheFastestWayAndOneAroundTheHazard) {
  const ResolvedWorld world{world_of({"a"}, {disc_source("fire", {5.0, 0.0}, 1.0, -3.0)})};
  const Hazards hazards{world, 0, 0.0};
  Travel travel{nullptr, &hazards, walker(), 0.0};
  const auto& ways = travel.ways(*travel.place_at({0.0, 0.0}, 0.5), *travel.place_at({10.0, 0.0}, 0.5));
  ASSERT_GE(ways.size(), 2U);
  EXPECT_DOUBLE_EQ(ways.front().length_m, 10.0);
  EXPECT_NEAR(ways.front().hazard, 6.0, 0.3);
  // Two tangents of sqrt(24) and an arc of 2 asin(1/5): 10.2 m, and a little for keeping outside.
  EXPECT_NEAR(ways.back().length_m, 2.0 * std::sqrt(24.0) + 2.0 * std::asin(0.2), 0.15);
  EXPECT_DOUBLE_EQ(ways.back().hazard, 0.0);
}

TEST(Travel, GoesAroundWallsInARoomFromPointToPoint) {
  // 6 x 4 m, a wall from the bottom up to 2 m in the middle.
  const OccupancyGrid map = room({
      "##############",  //
      "#............#",
      "#............#",
      "#............#",
      "#............#",
      "#.....##.....#",
      "#.....##.....#",
      "#.....##.....#",
      "#.....##.....#",
      "##############",
  });
  const ResolvedWorld world{world_of({"a"}, {})};
  const Hazards hazards{world, 0, 0.0};
  MotionOptions body;
  body.radius_m = 0.2;
  body.preferred_clearance_m = 0.2;
  const MotionMap motion{map, body};
  Travel travel{&motion, &hazards, walker(), 0.0};
  const auto& ways = travel.ways(*travel.place_at({1.53, 1.0}, 0.5), *travel.place_at({5.47, 1.0}, 0.5));
  ASSERT_EQ(ways.size(), 1U);
  const TravelWay& way = ways.front();
  EXPECT_EQ(way.points_in_map.front(), (Vector2d{1.53, 1.0}));
  EXPECT_EQ(way.points_in_map.back(), (Vector2d{5.47, 1.0}));
  // Up over the wall's end at 2.5 with 0.2 m of room, 1.4 m across.
  EXPECT_NEAR(way.length_m, 1.0 + 2.0 * std::hypot(1.47, 1.7), 0.4);
  for (std::size_t i = 1; i < way.points_in_map.size(); ++i) {
    EXPECT_GE(motion.clearance_m(way.points_in_map[i - 1], way.points_in_map[i]), 0.17);
  }
}

TEST(Travel, HasNoPlaceInAWall) {
  const OccupancyGrid map = empty_room(4, 4);
  const ResolvedWorld world{world_of({"a"}, {})};
  const Hazards hazards{world, 0, 0.0};
  const MotionMap motion{map, {}};
  Travel travel{&motion, &hazards, walker(), 0.0};
  EXPECT_FALSE(travel.place_at({-3.0, 2.0}, 0.5));
  ASSERT_TRUE(travel.place_at({0.6, 2.0}, 0.5));  // too near the wall: the nearest standpoint
}

}  // namespace
}  // namespace tandem
