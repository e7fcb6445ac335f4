#include "services/navigator/core/avoidance.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tandem::navigator {
namespace {

using Points = std::vector<Eigen::Vector2d>;

/// At the beginning of a path of 10 m straight ahead. The hull is 0.6 m x 0.5 m and the tightest arc turns in 0.5 m.
class AvoidanceTest : public ::testing::Test {
 protected:
  static NavigatorConfig config() {
    NavigatorConfig config;
    config.hull_length_m = 0.6;
    config.hull_width_m = 0.5;
    config.min_turn_radius_m = 0.5;
    return config;
  }
  Course course(const Points& obstacles) { return avoidance.course(aim, path, {}, obstacles); }
  /// Points every 0.1 m from one to the other.
  static Points wall(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    Points points;
    const double length_m = (to - from).norm();
    for (double way_m = 0.0; way_m <= length_m + 1e-9; way_m += 0.1) {
      points.push_back(from + (to - from) * way_m / length_m);
    }
    return points;
  }
  static Points mirrored(Points points) {
    for (auto& point : points) point.y() = -point.y();
    return points;
  }

  Aim aim{.remaining_m = 10.0, .point_in_base = {0.6, 0.0}};
  Path path{{{0.0, 0.0}, {10.0, 0.0}}};
  Avoidance avoidance{config()};
};

TEST_F(AvoidanceTest, WhereThePathIsFreeItDrivesAsThePathAsks) {
  aim.curvature = 0.3;
  const Course free = course({});
  EXPECT_EQ(free.kind, Course::Kind::Arc);
  EXPECT_DOUBLE_EQ(free.curvature, 0.3);
  EXPECT_FALSE(free.detour);
  EXPECT_EQ(free.nearest_m, std::numeric_limits<double>::infinity());
  const Course passing = course({{1.3, 2.0}});  // far aside: 1 m ahead of the hull's front, 1.75 m beside it
  EXPECT_FALSE(passing.detour);
  EXPECT_NEAR(passing.nearest_m, std::hypot(1.0, 1.75), 1e-12);
}

TEST_F(AvoidanceTest, NoArcIsTighterThanItCanTurn) {
  aim.curvature = 9.0;
  EXPECT_DOUBLE_EQ(course({}).curvature, 2.0);
  aim.curvature = -9.0;
  EXPECT_DOUBLE_EQ(course({}).curvature, -2.0);
}

TEST_F(AvoidanceTest, PassesWhatIsInTheWayOnTheSideWithMoreRoomAndItsMirrorImageOnTheOther) {
  const Points box = wall({1.2, -0.3}, {1.2, 0.1});  // reaches further to the right
  const Course left = course(box);
  EXPECT_EQ(left.kind, Course::Kind::Arc);
  EXPECT_TRUE(left.detour);
  EXPECT_GT(left.curvature, 0.0);
  avoidance = Avoidance{config()};
  const Course right = course(mirrored(box));
  EXPECT_TRUE(right.detour);
  EXPECT_NEAR(right.curvature, -left.curvature, 1e-9);
}

TEST_F(AvoidanceTest, BeforeAWallWithoutAWayAroundItDrivesUpToItAndStands) {
  // From 0.3 m (the hull's front) to 1.3 m it is 1 m, less 0.05 m margin.
  const Course far = course(wall({1.3, -3.0}, {1.3, 3.0}));
  EXPECT_EQ(far.kind, Course::Kind::Arc);
  EXPECT_NEAR(far.free.way_m, 0.95, 1e-9);
  avoidance = Avoidance{config()};
  Points closed = wall({0.5, -0.5}, {0.5, 0.5});
  for (const double y : {-0.4, 0.4}) {
    const Points side = wall({-0.6, y}, {0.5, y});
    closed.insert(closed.end(), side.begin(), side.end());
  }
  const Course near = course(closed);
  EXPECT_EQ(near.kind, Course::Kind::Stand);
  EXPECT_NEAR(near.free.obstacle_in_base.x(), 0.5, 1e-9);  // what is in its way
}

TEST_F(AvoidanceTest, TurnsInPlaceOnlyWithRoomAndNeedsLessToGoOnThanToBegin) {
  aim.turn_in_place = true;
  aim.point_in_base = {-1.0, 0.1};
  EXPECT_EQ(course({}).kind, Course::Kind::TurnInPlace);
  // The hull's corners draw a circle of 0.39 m; 0.14 m around it are needed to begin, 0.115 m to go on.
  const Points beside{{0.0, 0.52}};
  EXPECT_EQ(course(beside).kind, Course::Kind::TurnInPlace);
  avoidance = Avoidance{config()};
  EXPECT_NE(course(beside).kind, Course::Kind::TurnInPlace);
}

TEST_F(AvoidanceTest, WithoutRoomToTurnItDrivesToWhereThereIs) {
  aim.turn_in_place = true;
  aim.point_in_base = {0.0, 1.0};
  const Course away = course({{0.0, -0.45}});  // something close on the right, all else is free
  EXPECT_EQ(away.kind, Course::Kind::Arc);
  EXPECT_TRUE(away.detour);
  EXPECT_GE(away.curvature, 0.0);
}

}  // namespace
}  // namespace tandem::navigator
