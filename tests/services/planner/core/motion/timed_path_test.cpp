#include "services/planner/core/motion/timed_path.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tandem {
namespace {

using Eigen::Vector2d;

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

}  // namespace
}  // namespace tandem
