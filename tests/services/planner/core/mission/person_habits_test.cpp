#include "services/planner/core/mission/person_habits.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/room.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;
using std::chrono::seconds;

const Time kStart = from_stamp_ns(1'700'000'000'000'000'000);

TEST(PersonHabits, WhoWasNeverOffAPlanIsTrusted) {
  PersonHabits habits(60.0);
  EXPECT_EQ(habits.stray_probability(), 0.0);
  for (int i = 0; i <= 30; ++i) habits.follow(kStart + seconds{i}, true);
  EXPECT_EQ(habits.stray_probability(), 0.0);
}

TEST(PersonHabits, WhoStraysIsTrustedLess) {
  PersonHabits habits(60.0);
  for (int i = 0; i <= 20; ++i) habits.follow(kStart + seconds{i}, false);
  EXPECT_DOUBLE_EQ(habits.stray_probability(), 20.0 / 80.0);
  for (int i = 21; i <= 40; ++i) habits.follow(kStart + seconds{i}, true);
  EXPECT_DOUBLE_EQ(habits.stray_probability(), 20.0 / 100.0);
}

TEST(PersonHabits, WhatNobodyCouldTellCountsNeitherWay) {
  PersonHabits habits(60.0);
  habits.follow(kStart, false);
  for (int i = 1; i <= 20; ++i) habits.follow(kStart + seconds{i}, std::nullopt);
  habits.follow(kStart + seconds{100}, false);  // after a long gap: one second at most
  EXPECT_DOUBLE_EQ(habits.stray_probability(), 1.0 / 61.0);
}

TEST(PersonHabits, ACourseIsWhereTheyHaveWalked) {
  PersonHabits habits(60.0);
  EXPECT_FALSE(habits.course());
  for (int i = 0; i < 20; ++i) habits.seen(kStart + seconds{i}, {3.0, 0.5 * i});
  ASSERT_TRUE(habits.course());
  EXPECT_LT((*habits.course() - Vector2d{0, 1}).norm(), 1e-12);
  for (int i = 20; i < 40; ++i) habits.seen(kStart + seconds{i}, {3.0, 9.5});
  EXPECT_FALSE(habits.course());
}

TEST(PersonHabits, StraightOnEndsBeforeTheWall) {
  const MotionMap motion(empty_room(8, 4), {});
  const TimedPath path = straight_on(motion, {2.0, 2.5}, Vector2d{1, 0}, 0.5, 0.3, 60.0);
  ASSERT_EQ(path.points.size(), 2U);
  EXPECT_GT(path.points[1].point_in_map.x(), 7.5);  // the wall is at 8.5
  EXPECT_LE(path.points[1].point_in_map.x(), 8.3);
  EXPECT_DOUBLE_EQ(path.duration_s(), (path.points[1].point_in_map.x() - 2.0) / 0.5);
}

TEST(PersonHabits, ACourseIsKeptForAWhileOnly) {
  const MotionMap motion(empty_room(8, 4), {});
  EXPECT_DOUBLE_EQ(straight_on(motion, {2.0, 2.5}, Vector2d{1, 0}, 0.5, 0.3, 4.0).duration_s(), 4.0);
  EXPECT_EQ(straight_on(motion, {2.0, 2.5}, std::nullopt, 0.5, 0.3, 4.0).points.size(), 1U);
}

TEST(PersonHabits, TheRestOfAPathBeginsWhereTheyAre) {
  const TimedPath path{{{0.0, {0, 0}}, {4.0, {4, 0}}, {8.0, {4, 4}}}};
  const TimedPath rest = rest_of(path, 3.0, {2.9, 0.1});
  ASSERT_EQ(rest.points.size(), 3U);
  EXPECT_EQ(rest.points[0].point_in_map, Vector2d(2.9, 0.1));
  EXPECT_DOUBLE_EQ(rest.points[1].time_s, 1.0);
  EXPECT_EQ(rest.points[2].point_in_map, Vector2d(4, 4));
  EXPECT_EQ(rest_of(path, 9.0, {4, 4}).points.size(), 1U);
}

}  // namespace
}  // namespace tandem
