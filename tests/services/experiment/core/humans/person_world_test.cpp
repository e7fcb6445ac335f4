#include "services/experiment/core/humans/person_world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/services/experiment/core/humans/hall.hpp"

namespace tandem::experiment {
namespace {

TEST(PersonWorld, AnEmptyHallIsAllFloorAndAWayIsStraight) {
  Hall hall;
  EXPECT_NEAR(hall.world.area().area_m2(), 160.0, 1.0);
  const auto ways = hall.world.ways_from({2.0, 5.0});
  ASSERT_TRUE(ways);
  const int cell = *hall.world.area().cell_at({12.1, 5.1});
  EXPECT_NEAR(hall.world.distance_m(*ways, cell), 10.0, 0.5);
  const auto way = hall.world.way(*ways, cell);
  ASSERT_EQ(way.size(), 2U);
  EXPECT_NEAR((way.back() - Eigen::Vector2d(12.1, 5.1)).norm(), 0.0, 0.5);
}

TEST(PersonWorld, SeesADiscAroundThePerson) {
  Hall hall;
  // pi * 3^2 m2 in cells of 0.25 m2
  EXPECT_NEAR(static_cast<double>(hall.world.view_at({8.0, 5.0}).size()), 113.0, 6.0);
  EXPECT_TRUE(hall.world.view_at({-20.0, 5.0}).empty());
}

TEST(PersonWorld, NoFloorIsAnError) {
  EXPECT_THROW(PersonWorld(room({"####", "####"}), hall_person(), hall_options()), std::invalid_argument);
}

TEST(PersonWorld, BehindAWallThereIsNoWay) {
  PersonWorld world(room({"#########", "#...#...#", "#...#...#", "#########"}, 1.0), hall_person(), hall_options());
  EXPECT_FALSE(world.area().cell_at({6.0, 2.0}));  // not part of what is searched
}

TEST(OwnMemory, WhatWasLookedAtIsNoNews) {
  Hall hall;
  OwnMemory memory(hall.world);
  const int here = *hall.world.area().cell_at({8.0, 5.0});
  const double all_m2 = memory.news_m2(hall.world, here);
  EXPECT_NEAR(all_m2, 28.3, 1.5);  // pi * 3^2
  memory.look(hall.world, {8.0, 5.0});
  EXPECT_TRUE(memory.has_seen(here));
  EXPECT_EQ(memory.news_m2(hall.world, here), 0.0);
}

}  // namespace
}  // namespace tandem::experiment
