#include "services/planner/core/tasks/stations.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tandem {
namespace {

using Eigen::Vector2d;

ResolvedBoundary on_map(const PlanarShape& shape) {
  return PlacedShape{shape, -1};
}

TEST(Stations, LieInsideTheBoundaryTheMiddleFirst) {
  const std::vector<PlanarShape> shapes{
      Disc{{1.0, 2.0}, 0.3}, Disc{{1.0, 2.0}, 3.0}, Polygon{{{0.0, 0.0}, {6.0, 0.0}, {6.0, 4.0}, {0.0, 4.0}}},
      Corridor{{{0.0, 0.0}, {5.0, 0.0}, {5.0, 5.0}}, 0.5}, HalfPlane{{2.0, 0.0}, {1.0, 0.0}}};
  for (const auto& shape : shapes) {
    const auto stations = stations_of(on_map(shape), 0.0, {9.0, 9.0});
    ASSERT_FALSE(stations.empty());
    for (const auto& station : stations) EXPECT_TRUE(contains(shape, station)) << station.transpose();
  }
  EXPECT_EQ(stations_of(on_map(shapes[0]), 0.0, Vector2d::Zero()).size(), 1U);
  EXPECT_EQ(stations_of(on_map(shapes[1]), 0.0, Vector2d::Zero()).front(), (Vector2d{1.0, 2.0}));
  EXPECT_GT(stations_of(on_map(shapes[1]), 0.0, Vector2d::Zero()).size(), 4U);
}

TEST(Stations, OfAHalfPlaneIsWhereOneGetsIntoIt) {
  const auto stations = stations_of(on_map(HalfPlane{{2.0, 0.0}, {1.0, 0.0}}), 0.0, {5.0, 3.0});
  ASSERT_EQ(stations.size(), 1U);
  EXPECT_NEAR(stations[0].x(), 1.95, 1e-9);
  EXPECT_NEAR(stations[0].y(), 3.0, 1e-9);
}

TEST(Stations, OfABallAreAtTheAltitudeOfTheAgent) {
  const ResolvedBoundary ball = Sphere{{1.0, 1.0, 3.0}, 1.0};
  EXPECT_TRUE(stations_of(ball, 0.0, Vector2d::Zero()).empty());
  EXPECT_EQ(stations_of(ball, 3.0, Vector2d::Zero()).front(), (Vector2d{1.0, 1.0}));
}

TEST(Stations, AnEventAndAMovingBoundaryHaveNone) {
  EXPECT_TRUE(stations_of(Nowhere{}, 0.0, Vector2d::Zero()).empty());
  EXPECT_TRUE(stations_of(PlacedShape{Disc{{0.0, -1.0}, 0.5}, 0}, 0.0, Vector2d::Zero()).empty());
}

TEST(Stations, BesideAnAgentTurnsWithIt) {
  // At (4, 2), heading along y: its right side is towards +x.
  const std::vector<AgentMove> moves{stay_at({4.0, 2.0}, std::numbers::pi / 2.0), stay_at({0.0, 0.0})};
  const ResolvedBoundary beside = PlacedShape{Disc{{0.0, -1.0}, 0.5}, 0};
  const Vector2d station = moving_station(beside, {moves, 1.0});
  EXPECT_NEAR(station.x(), 5.0, 1e-9);
  EXPECT_NEAR(station.y(), 2.0, 1e-9);
  EXPECT_TRUE(is_moving(beside));
  EXPECT_TRUE(moves_with(beside, 0));
  EXPECT_FALSE(moves_with(beside, 1));
}

TEST(Stations, BetweenTwoIsTheMiddle) {
  const std::vector<AgentMove> moves{stay_at({4.0, 2.0}), stay_at({0.0, 0.0})};
  MovingCorridor between;
  between.from.agent = 0;
  between.to.point_in_map = {0.0, 2.0};
  between.half_width_m = 0.5;
  EXPECT_EQ(moving_station(between, {moves, 1.0}), (Vector2d{2.0, 2.0}));
}

}  // namespace
}  // namespace tandem
