#include "services/simulator/core/place.hpp"

#include <gtest/gtest.h>

#include "tests/support/ascii_map.hpp"

namespace tandem::simulator {
namespace {

Place two_rooms_with_a_door() {
  return Place{
      test::ascii_map({"###########", "#....#....#", "#....#....#", "#.........#", "#....#....#", "###########"})};
}

double length_of(const std::vector<Eigen::Vector2d>& walk) {
  double length = 0.0;
  for (std::size_t i = 1; i < walk.size(); ++i) length += (walk[i] - walk[i - 1]).norm();
  return length;
}

TEST(Place, ClearanceIsTheWayToTheNearestWall) {
  const Place place = two_rooms_with_a_door();
  EXPECT_DOUBLE_EQ(place.clearance_m({1.5, 1.5}), 0.5);  // the middle of a cell beside a wall
  EXPECT_DOUBLE_EQ(place.clearance_m({0.5, 0.5}), 0.0);
  EXPECT_DOUBLE_EQ(place.clearance_m({-3.0, 0.5}), 0.0);
}

TEST(Place, TheShortestWalkGoesThroughTheDoor) {
  const Place place = two_rooms_with_a_door();
  const auto walk = shortest_walk(place, {2.5, 4.5}, {8.5, 4.5}, 0.3);

  ASSERT_GE(walk.size(), 3U);
  EXPECT_EQ(walk.front(), Eigen::Vector2d(2.5, 4.5));
  EXPECT_EQ(walk.back(), Eigen::Vector2d(8.5, 4.5));
  EXPECT_GT(length_of(walk), 6.0);
  EXPECT_LT(length_of(walk), 8.5);
  for (std::size_t i = 1; i < walk.size(); ++i) EXPECT_TRUE(place.has_way(walk[i - 1], walk[i], 0.29));
}

TEST(Place, NoWalkLeadsThroughAWall) {
  const Place place{test::ascii_map({"#####", "#.#.#", "#####"})};
  EXPECT_TRUE(shortest_walk(place, {1.5, 1.5}, {3.5, 1.5}, 0.2).empty());
}

TEST(Place, AStraightWalkHasTwoEnds) {
  EXPECT_EQ(shortest_walk(two_rooms_with_a_door(), {1.5, 2.5}, {4.0, 2.5}, 0.3).size(), 2U);
}

TEST(Place, TheLargestGroundIsOneConnectedPiece) {
  const Place place{test::ascii_map({"########", "#.#....#", "########"})};
  const auto ground = place.largest_ground(0.4);
  ASSERT_EQ(ground.size(), 4U);
  EXPECT_EQ(ground.front(), Eigen::Vector2d(3.5, 1.5));
  EXPECT_EQ(ground.back(), Eigen::Vector2d(6.5, 1.5));
}

}  // namespace
}  // namespace tandem::simulator
