#include "services/planner/core/scenario/drawn_room.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

using Eigen::Vector2d;

DrawnRoom room_with_low_wall() {
  DrawnRoom room;
  room.width_m = 4.0;
  room.height_m = 3.0;
  room.walls.push_back({{{2.0, 0.0}, {2.0, 2.0}}, 0.2, 2.0});
  room.boxes.push_back({{3.0, 1.0}, {3.5, 1.5}});
  return room;
}

TEST(DrawnRoom, ItsInnerLowerLeftCornerIsTheOrigin) {
  const OccupancyGrid map = draw_layer(room_with_low_wall(), 0.0);
  EXPECT_EQ(map.at(Vector2d{0.05, 0.05}), CellState::Free);
  EXPECT_EQ(map.at(Vector2d{3.95, 2.95}), CellState::Free);
  EXPECT_EQ(map.at(Vector2d{-0.05, 1.0}), CellState::Occupied);
  EXPECT_EQ(map.at(Vector2d{4.05, 1.0}), CellState::Occupied);
}

TEST(DrawnRoom, WallsAndBoxesStandInTheWay) {
  const OccupancyGrid map = draw_layer(room_with_low_wall(), 0.0);
  EXPECT_EQ(map.at(Vector2d{2.05, 1.0}), CellState::Occupied);
  EXPECT_EQ(map.at(Vector2d{2.05, 2.5}), CellState::Free);
  EXPECT_EQ(map.at(Vector2d{3.25, 1.25}), CellState::Occupied);
}

TEST(DrawnRoom, WhatFliesHigherThanAWallPassesOverIt) {
  const OccupancyGrid map = draw_layer(room_with_low_wall(), 3.0);
  EXPECT_EQ(map.at(Vector2d{2.05, 1.0}), CellState::Free);
  EXPECT_EQ(map.at(Vector2d{3.25, 1.25}), CellState::Occupied);  // without a height, up to the sky
  EXPECT_EQ(map.at(Vector2d{-0.05, 1.0}), CellState::Occupied);
}

}  // namespace
}  // namespace tandem
