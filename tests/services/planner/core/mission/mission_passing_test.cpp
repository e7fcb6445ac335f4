#include <gtest/gtest.h>

#include <algorithm>
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

SourceEdit behind(const std::string& whom, std::vector<std::string> targets = {}) {
  SourceEdit edit;
  edit.kind = SourceEdit::Kind::StayBehind;
  edit.source_id = "behind";
  edit.who = whom;
  edit.targets = std::move(targets);
  return edit;
}

double least_x(const TimedPath& path) {
  double least = std::numeric_limits<double>::infinity();
  for (const TimedPoint& point : path.points) least = std::min(least, point.point_in_map.x());
  return least;
}

/// The person in the middle looks to the left, where everything is that is still to be found; the robot is behind them.
class MissionBehind : public MissionInHall {
 protected:
  MissionBehind() {
    robot = {12.0, 5.0, 0.0};
    person = {8.0, 5.0, from_degrees(180.0)};
    run();
    const PlanarShape right = Polygon{{{8, 0}, {17, 0}, {17, 11}, {8, 11}}};
    pass(seconds{1});
    EXPECT_FALSE(mission.edit_belief({BeliefEdit::Kind::NotHere, right, "very"}));
    EXPECT_TRUE(plan());
  }
};

TEST_F(MissionBehind, TheRobotGoesNoFartherThanThePerson) {
  EXPECT_LT(least_x(paths()[kRobot]), 7.5);  // past the person, if nobody says otherwise
  EXPECT_FALSE(mission.edit_source(behind("person"), now));
  EXPECT_EQ(mission.standing(now), PlanStanding::Superseded);  // it led there
  ASSERT_TRUE(plan());
  EXPECT_GE(least_x(paths()[kRobot]), 8.0);
  EXPECT_LT(least_x(paths()[kPerson]), 7.0);
  ASSERT_EQ(mission.sources().size(), 1U);
  EXPECT_EQ(mission.sources()[0].meaning, "stay behind person");

  person = {5.0, 5.0, from_degrees(180.0)};  // they have gone on
  pass(seconds{1});
  EXPECT_FALSE(mission.request({PersonRequest::Kind::Replan, {}}, now));
  ASSERT_TRUE(plan());
  EXPECT_GE(least_x(paths()[kRobot]), 5.0);
  EXPECT_LT(least_x(paths()[kRobot]), 8.0);
}

TEST_F(MissionBehind, ItGoesEverywhereAgainWhenItNeedNotStayBehind) {
  EXPECT_FALSE(mission.edit_source(behind("person", {"robot"}), now));
  ASSERT_TRUE(plan());
  SourceEdit gone;
  gone.source_id = "behind";
  EXPECT_FALSE(mission.edit_source(gone, now));
  ASSERT_TRUE(plan());
  EXPECT_LT(least_x(paths()[kRobot]), 7.0);
}

TEST_F(MissionBehind, ARobotThatIsAheadGetsBehindFirst) {
  person = {14.0, 5.0, from_degrees(180.0)};
  pass(seconds{1});
  EXPECT_FALSE(mission.edit_source(behind("person"), now));
  ASSERT_TRUE(plan());
  const Vector2d end = paths()[kRobot].points.back().point_in_map;
  EXPECT_NEAR(end.x(), 15.5, 0.2);  // 1.5 m behind the person
  EXPECT_NEAR(end.y(), 5.0, 0.2);
  EXPECT_NEAR(length_until_m(paths()[kRobot], 1e9), 3.5, 0.2);
  EXPECT_FALSE(mission.plan()->members[kRobot].goal_fixed);
}

TEST_F(MissionBehind, WhenThePersonTurnsRoundTheRobotGetsBehindAgain) {
  EXPECT_FALSE(mission.edit_source(behind("person"), now));
  ASSERT_TRUE(plan());
  person.heading = 0.0;
  for (int i = 0; i < 19; ++i) {
    pass(seconds{1});
    EXPECT_FALSE(mission.step(now, kNeverOver));
  }
  pass(seconds{2});  // 20 s after the last plan, not before
  ASSERT_TRUE(plan());
  EXPECT_EQ(mission.plan()->reason, "the robot is ahead of the person");
  EXPECT_NEAR(paths()[kRobot].points.back().point_in_map.x(), 6.5, 0.2);
}

TEST_F(MissionBehind, WhatCannotBeIsRefused) {
  EXPECT_EQ(mission.edit_source(behind(""), now), "it is not said behind whom");
  EXPECT_EQ(mission.edit_source(behind("person", {"person"}), now), "nobody can stay behind themselves");
  EXPECT_EQ(mission.edit_source(behind("robot", {"person"}), now), "only the robot can be kept behind somebody");
  EXPECT_FALSE(mission.edit_source(behind("person"), now));
  SourceEdit again = behind("person");
  again.source_id = "again";
  EXPECT_EQ(mission.edit_source(again, now), "the robot stays behind already");
}

}  // namespace
}  // namespace tandem
