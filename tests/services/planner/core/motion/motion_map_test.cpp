#include "services/planner/core/motion/motion_map.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace tandem
