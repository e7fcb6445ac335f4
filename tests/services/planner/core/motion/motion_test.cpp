#include <gtest/gtest.h>

#include <cmath>

#include "services/planner/core/motion/action_set.hpp"
#include "tests/services/planner/support/room.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

double length_m(const std::vector<Vector2d>& way) {
  double sum = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) sum += (way[i] - way[i - 1]).norm();
  return sum;
}

TEST(MotionMap, InTheOpenTheWayIsStraight) {
  const OccupancyGrid map = empty_room(10, 10);
  const MotionMap motion(map, {});
  const int from = *motion.nearest_node({2, 2}, 1.0);
  const int to = *motion.nearest_node({8, 8}, 1.0);
  const auto way = motion.way(motion.shortest_paths(from), to);

  EXPECT_EQ(way.front(), motion.point(from));
  EXPECT_EQ(way.back(), motion.point(to));
  EXPECT_LT(length_m(way), 1.02 * (motion.point(to) - motion.point(from)).norm());
}

TEST(MotionMap, GoesAroundAWallWithClearance) {
  const OccupancyGrid map = room({"############", "#....##....#", "#....##....#", "#....##....#", "#..........#",
                                  "#..........#", "#..........#", "############"});
  MotionOptions robot;
  robot.radius_m = 0.45;
  const MotionMap motion(map, robot);
  const auto way =
      motion.way(motion.shortest_paths(*motion.nearest_node({1.5, 3}, 0.5)), *motion.nearest_node({4.5, 3}, 0.5));

  ASSERT_GE(way.size(), 3U);
  for (std::size_t i = 1; i < way.size(); ++i) EXPECT_GE(motion.clearance_m(way[i - 1], way[i]), 0.43);
}

TEST(MotionMap, ARobotDoesNotFitThroughAGapForAPerson) {
  // A gap of 0.7 m: signs of 0.7 m.
  const OccupancyGrid map = room({"#########", "#...#...#", "#.......#", "#...#...#", "#########"}, 0.7);
  MotionOptions person;
  person.radius_m = 0.25;
  MotionOptions robot;
  robot.radius_m = 0.45;
  const auto fits = [&](const MotionOptions& options) {
    const MotionMap motion(map, options);
    return !motion
                .way(motion.shortest_paths(*motion.nearest_node({1.7, 1.7}, 1.0)),
                     *motion.nearest_node({4.6, 1.7}, 1.0))
                .empty();
  };
  EXPECT_TRUE(fits(person));
  EXPECT_FALSE(fits(robot));
}

TEST(MotionMap, ABlockedPlaceIsAvoided) {
  const OccupancyGrid map = empty_room(10, 6);
  const MotionMap motion(map, {}, {{{5, 3}, 0.8}});
  const auto way =
      motion.way(motion.shortest_paths(*motion.nearest_node({2, 3}, 0.5)), *motion.nearest_node({8, 3}, 0.5));

  ASSERT_GE(way.size(), 3U);
  for (std::size_t i = 1; i < way.size(); ++i) EXPECT_GT(motion.clearance_m(way[i - 1], way[i]), 0.0);
}

TEST(TimedPath, ARobotTurnsOnTheSpotAndAPersonDoesNot) {
  Searcher robot;
  robot.speed_mps = 0.5;
  robot.turn_rate_radps = std::numbers::pi / 4.0;
  robot.field_of_view_rad = 1.0;
  const std::vector<Vector2d> way{{0, 0}, {2, 0}, {2, 1}};

  EXPECT_NEAR(timed_path(way, robot, 0.0).duration_s(), 4.0 + 2.0 + 2.0, 1e-9);  // 2 m, quarter turn, 1 m
  robot.field_of_view_rad = 2.0 * std::numbers::pi;
  EXPECT_NEAR(timed_path(way, robot, 0.0).duration_s(), 6.0, 1e-9);
}

TEST(TimedPath, SaysWhereOneIs) {
  Searcher person;
  person.speed_mps = 1.0;
  const TimedPath path = timed_path({{0, 0}, {2, 0}, {2, 1}}, person, 0.0);

  EXPECT_EQ(pose_at(path, 0.5), (Pose2{0.5, 0.0, 0.0}));
  EXPECT_NEAR(pose_at(path, 2.5).y, 0.5, 1e-12);
  EXPECT_NEAR(pose_at(path, 2.5).heading, std::numbers::pi / 2.0, 1e-12);
  EXPECT_NEAR(pose_at(path, 99.0).y, 1.0, 1e-12);
}

TEST(CoveringLookouts, TogetherSeeNearlyEverything) {
  const OccupancyGrid map = room({"################", "#......#.......#", "#......#.......#", "#..............#",
                                  "#......#.......#", "#......#.......#", "################"},
                                 1.0);
  SearchAreaOptions options;
  options.start_in_map = {2, 3};
  const SearchArea area(map, options);
  Observability sight(map, area, 4.0);
  const MotionMap motion(map, {});
  const auto lookouts = covering_lookouts(sight, motion, *motion.nearest_node({2, 3}, 1.0), 3.0, 0.5);

  std::vector<bool> seen(static_cast<std::size_t>(area.size()), false);
  for (const int node : lookouts) {
    for (const int cell : sight.in_sight_of(*area.nearest_cell(motion.point(node), 0.5))) {
      seen[static_cast<std::size_t>(cell)] = true;
    }
  }
  EXPECT_GE(lookouts.size(), 4U);
  EXPECT_LE(lookouts.size(), 12U);
  EXPECT_GE(std::count(seen.begin(), seen.end(), true), 0.97 * area.size());
}

}  // namespace
}  // namespace tandem
