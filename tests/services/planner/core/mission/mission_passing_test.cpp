#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/services/planner/support/mission_in_hall.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;
using std::chrono::seconds;

using MissionPassing = MissionInHall;

constexpr std::size_t kRobot = SearchMission::kRobot;
constexpr std::size_t kPerson = SearchMission::kPerson;

SourceEdit through(const PlanarShape& region, std::vector<std::string> targets, const std::string& id = "s1") {
  SourceEdit edit;
  edit.kind = SourceEdit::Kind::PassThrough;
  edit.source_id = id;
  edit.region = region;
  edit.targets = std::move(targets);
  return edit;
}

/// When the path is first within the region, in steps of 0.1 s; infinite if it never is.
double entry_s(const TimedPath& path, const PlanarShape& region) {
  for (double time_s = 0.0; time_s <= path.duration_s(); time_s += 0.1) {
    if (contains(region, pose_at(path, time_s).position())) return time_s;
  }
  return std::numeric_limits<double>::infinity();
}

double length_until_m(const TimedPath& path, double end_s) {
  const TimedPath part = path_until(path, end_s);
  double sum_m = 0.0;
  for (std::size_t i = 1; i < part.points.size(); ++i) {
    sum_m += (part.points[i].point_in_map - part.points[i - 1].point_in_map).norm();
  }
  return sum_m;
}

TEST_F(MissionPassing, APlanLeadsThroughAndOn) {
  run();
  ASSERT_TRUE(plan());
  const PlanarShape corner = Disc{{15.0, 9.0}, 0.3};  // seen from afar: nobody needs to go there
  ASSERT_GT(entry_s(paths()[kRobot], corner), 1e3);
  EXPECT_FALSE(mission.edit_source(through(corner, {"robot"}), now));
  ASSERT_TRUE(plan());
  EXPECT_EQ(mission.plan()->reason, "the person drew on the map");
  const double there_s = entry_s(paths()[kRobot], corner);
  EXPECT_LT(there_s, paths()[kRobot].duration_s() - 1.0);  // the search goes on behind it
  EXPECT_NEAR(length_until_m(paths()[kRobot], there_s), std::hypot(12.0, 6.0) - 0.3, 0.2);  // straight
  EXPECT_FALSE(mission.plan()->members[kRobot].goal_fixed);
  EXPECT_EQ(mission.plan()->role, Role::LeaderFollower);
}

TEST_F(MissionPassing, ThePersonIsLedToo) {
  run();
  const PlanarShape corner = Disc{{15.0, 1.0}, 0.3};
  EXPECT_FALSE(mission.edit_source(through(corner, {"person"}), now));
  ASSERT_TRUE(plan());
  EXPECT_LT(entry_s(paths()[kPerson], corner), paths()[kPerson].duration_s());
  EXPECT_GT(entry_s(paths()[kRobot], corner), 1e3);
}

TEST_F(MissionPassing, AFixedGoalIsReachedThroughThePlace) {
  run();
  const Vector2d goal{9.0, 3.0};
  EXPECT_FALSE(mission.request({PersonRequest::Kind::RobotGoal, goal}, now));
  EXPECT_FALSE(mission.edit_source(through(Disc{{6.0, 7.0}, 0.2}, {"robot"}), now));
  ASSERT_TRUE(plan());
  const TimedPath path = paths()[kRobot];
  const double there_s = entry_s(path, Disc{{6.0, 7.0}, 0.2});
  EXPECT_NEAR(length_until_m(path, there_s), 5.0 - 0.2, 0.1);  // from (3, 3): 3, 4, 5, straight
  EXPECT_TRUE(mission.plan()->members[kRobot].goal_fixed);
  EXPECT_LE((path.points.back().point_in_map - goal).norm(), kGoalReach_m);
  EXPECT_GE(length_until_m(path, path.duration_s()), 10.0 - kGoalReach_m);  // and 5 m to the goal
  // What is to be passed on the way pays only before the goal is reached.
  ASSERT_EQ(mission.relations().size(), 1U);
  EXPECT_EQ(mission.relations()[0].kind, RelationKind::Soft);
  EXPECT_EQ(mission.relations()[0].from, "s1");
}

TEST_F(MissionPassing, PlacesArePassedInTheOrderInWhichTheyWereDrawn) {
  run();
  const PlanarShape first = Disc{{12.0, 3.0}, 0.2};
  const PlanarShape second = Disc{{6.0, 8.0}, 0.2};
  EXPECT_FALSE(mission.edit_source(through(first, {"robot"}, "first"), now));
  EXPECT_FALSE(mission.edit_source(through(second, {"robot"}, "second"), now));
  ASSERT_TRUE(plan());
  EXPECT_NEAR(entry_s(paths()[kRobot], first), (9.0 - 0.2) / 0.5, 1.0);  // straight ahead at 0.5 m/s
  EXPECT_LT(entry_s(paths()[kRobot], first), entry_s(paths()[kRobot], second));
  EXPECT_LT(entry_s(paths()[kRobot], second), paths()[kRobot].duration_s());
}

TEST_F(MissionPassing, APlaceThatWasPassedIsDone) {
  run();
  EXPECT_FALSE(mission.edit_source(through(Disc{{8.0, 3.0}, 0.5}, {"robot"}), now));
  EXPECT_EQ(mission.sources().size(), 1U);
  person = {8, 3, 0};  // not meant
  pass(seconds{1});
  mission.step(now, kNeverOver);
  EXPECT_EQ(mission.sources().size(), 1U);
  robot = {7.6, 3, 0};
  pass(seconds{1});
  mission.step(now, kNeverOver);
  EXPECT_TRUE(mission.sources().empty());
}

TEST_F(MissionPassing, APlaceIsNoneAnyMoreWhenItIsTakenAway) {
  run();
  const PlanarShape corner = Disc{{15.0, 9.0}, 0.3};
  EXPECT_FALSE(mission.edit_source(through(corner, {"robot"}), now));
  ASSERT_TRUE(plan());
  SourceEdit gone;
  gone.source_id = "s1";
  EXPECT_FALSE(mission.edit_source(gone, now));
  ASSERT_TRUE(plan());
  EXPECT_GT(entry_s(paths()[kRobot], corner), 1e3);
}

TEST_F(MissionPassing, WhatCannotBePassedIsRefused) {
  run();
  EXPECT_EQ(mission.edit_source(through(Disc{{90.0, 90.0}, 2.0}, {"robot"}), now),
            "there is no floor to pass over there");
  EXPECT_EQ(mission.edit_source(through(Disc{{3.0, 3.0}, 1.0}, {"robot"}), now), "robot stands there");
  SourceEdit strip = through(Polygon{{{7, 0}, {10, 0}, {10, 11}, {7, 11}}}, {"robot"}, "strip");
  strip.kind = SourceEdit::Kind::Avoid;
  EXPECT_FALSE(mission.edit_source(strip, now));
  EXPECT_EQ(mission.edit_source(through(Disc{{14.0, 5.0}, 1.0}, {"robot"}), now), "no way leads robot through there");
  EXPECT_FALSE(mission.edit_source(through(Disc{{14.0, 5.0}, 1.0}, {"person"}), now));
  EXPECT_EQ(mission.sources().size(), 2U);
}

}  // namespace
}  // namespace tandem
