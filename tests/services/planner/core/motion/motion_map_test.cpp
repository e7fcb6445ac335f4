#include "services/planner/core/motion/motion_map.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/services/planner/support/room.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

double length_m(const std::vector<Vector2d>& way) {
  double sum = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) sum += (way[i] - way[i - 1]).norm();
  return sum;
}

std::vector<Vector2d> way_between(const MotionMap& motion, const Vector2d& from, const Vector2d& to) {
  const auto paths = motion.shortest_paths(*motion.nearest_node(from, 1.0));
  return motion.way(paths, *motion.nearest_node(to, 1.0), from, to);
}

TEST(MotionMap, InTheOpenTheWayIsStraight) {
  const OccupancyGrid map = empty_room(10, 10);
  const MotionMap motion(map, {});
  const auto way = way_between(motion, {2, 2}, {8, 8});

  EXPECT_EQ(way.front(), (Vector2d{2, 2}));
  EXPECT_EQ(way.back(), (Vector2d{8, 8}));
  EXPECT_LT(length_m(way), 1.02 * (Vector2d{8, 8} - Vector2d{2, 2}).norm());
}

TEST(MotionMap, GoesAroundAWallWithClearance) {
  const OccupancyGrid map = room({"############", "#....##....#", "#....##....#", "#....##....#", "#..........#",
                                  "#..........#", "#..........#", "############"});
  MotionOptions robot;
  robot.radius_m = 0.45;
  const MotionMap motion(map, robot);
  const auto way = way_between(motion, {1.5, 3}, {4.5, 3});

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
    return !way_between(motion, {1.7, 1.7}, {4.6, 1.7}).empty();
  };
  EXPECT_TRUE(fits(person));
  EXPECT_FALSE(fits(robot));
}

TEST(MotionMap, TheNearestPlaceIsFoundHoweverFarOneLooks) {
  const OccupancyGrid map = empty_room(4, 4);
  const MotionMap motion(map, {});
  const auto nearby = motion.nearest_node({2, 2}, 1.0);
  ASSERT_TRUE(nearby);
  EXPECT_EQ(motion.nearest_node({2, 2}, 1e9), nearby);
  EXPECT_EQ(motion.nearest_node({2, 2}, std::numeric_limits<double>::infinity()), nearby);
  EXPECT_FALSE(motion.nearest_node({2, -30}, 10.0));
  const auto from_far = motion.nearest_node({2, -30}, 100.0);
  ASSERT_TRUE(from_far);
  EXPECT_NEAR(motion.point(*from_far).x(), 2.0, 0.3);
  EXPECT_LT(motion.point(*from_far).y(), 1.0);
}

TEST(MotionMap, ABlockedPlaceIsAvoided) {
  const OccupancyGrid map = empty_room(10, 6);
  const MotionMap motion(map, {}, {{{5, 3}, 0.8}});
  const auto way = way_between(motion, {2, 3}, {8, 3});

  ASSERT_GE(way.size(), 3U);
  for (std::size_t i = 1; i < way.size(); ++i) EXPECT_GT(motion.clearance_m(way[i - 1], way[i]), 0.0);
}

}  // namespace
}  // namespace tandem
