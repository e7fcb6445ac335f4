#include <gtest/gtest.h>

#include "tests/services/planner/support/mission_in_hall.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;
using std::chrono::milliseconds;
using std::chrono::seconds;

/// A hall of 16 m x 10 m in which the person, at the left, does not see the robot at the right.
class MissionInformingTest : public MissionInHall {
 protected:
  MissionInformingTest() {
    run();
    EXPECT_TRUE(plan());
    robot = {12, 5, 0};
    person = {2, 2, 0};
  }
  /// The robot searches the right half while the person stays; plans are made as they come.
  void robot_searches(Duration duration) {
    double heading_rad = 0.0;
    for (const Time end = now + duration; now < end; now += milliseconds{200}) {
      heading_rad += 0.1;
      robot.heading = wrap_to_pi(heading_rad);
      tell_poses();
      mission.step(now, kNeverOver);
    }
  }
  /// Somebody else draws a place to keep out of where a person at `person` runs into it on the way to the right.
  void somebody_draws() {
    SourceEdit edit{SourceEdit::Kind::Avoid, "hole", Disc{{8.0, 2.0}, 1.0}, "very", {}, "operator"};
    EXPECT_FALSE(mission.edit_source(edit, now));
  }
  void walk_to_the_right(Duration duration) {
    for (const Time end = now + duration; now < end; now += milliseconds{200}) {
      person.x += 0.2 * 0.5;
      tell_poses();
      mission.step(now, kNeverOver);
    }
  }
};

TEST_F(MissionInformingTest, WhoDoesWhatThePlanSaysNeedsToBeToldNothing) {
  robot_searches(seconds{8});
  EXPECT_FALSE(mission.inform());
}

TEST_F(MissionInformingTest, WhoGoesTheirOwnWayIsToldOfAPlaceTheyWouldWalkInto) {
  EXPECT_FALSE(mission.request({PersonRequest::Kind::MyGoal, {15, 9}}, now));  // they choose their way themselves
  somebody_draws();
  walk_to_the_right(seconds{8});
  ASSERT_TRUE(mission.inform());
  EXPECT_EQ(mission.inform()->source_id, "hole");
  EXPECT_TRUE(mission.inform()->reason.starts_with("operator has drawn a place to keep out of, "));
}

TEST_F(MissionInformingTest, WhatTheyHaveDrawnThemselvesTheyKnow) {
  EXPECT_FALSE(mission.request({PersonRequest::Kind::MyGoal, {15, 9}}, now));
  SourceEdit own{SourceEdit::Kind::Avoid, "hole", Disc{{8.0, 2.0}, 1.0}, "very", {}, "person"};
  EXPECT_FALSE(mission.edit_source(own, now));
  walk_to_the_right(seconds{8});
  EXPECT_TRUE(!mission.inform() || mission.inform()->source_id != "hole");
}

TEST_F(MissionInformingTest, WhatTheyHaveTakenNoticeOfIsNotToldAgain) {
  EXPECT_FALSE(mission.request({PersonRequest::Kind::MyGoal, {15, 9}}, now));
  somebody_draws();
  walk_to_the_right(seconds{6});
  ASSERT_TRUE(mission.inform());
  const auto number = mission.inform()->number;
  mission.inform_heard(number);
  for (int i = 0; i < 10; ++i) {  // 60 s, to and fro
    person.x = 2.5;
    walk_to_the_right(seconds{6});
    EXPECT_TRUE(mission.inform()->number == number || mission.inform()->source_id != "hole");
  }
}

TEST_F(MissionInformingTest, WhatWasSaidOfAnotherMapDoesNotCountAnyMore) {
  EXPECT_FALSE(mission.request({PersonRequest::Kind::MyGoal, {15, 9}}, now));
  somebody_draws();
  walk_to_the_right(seconds{6});
  ASSERT_TRUE(mission.inform());
  const auto number = mission.inform()->number;
  mission.set_map(empty_room(20, 12));
  EXPECT_FALSE(mission.inform());
  mission.inform_heard(number);  // they press too late
}

TEST_F(MissionInformingTest, WhoGoesTheirOwnWayIsToldWhatTheRobotHasSearchedOutOfTheirSight) {
  // It is very likely over there, they say. The robot looks all around there, and they do not see it.
  BeliefEdit hint{BeliefEdit::Kind::LikelyHere, Disc{{12.0, 5.0}, 3.0}, "very", "person"};
  EXPECT_FALSE(mission.edit_belief(hint));
  EXPECT_FALSE(mission.request({PersonRequest::Kind::MyGoal, {3, 9}}, now));
  robot_searches(seconds{40});
  ASSERT_TRUE(mission.inform());
  EXPECT_EQ(mission.inform()->source_id, "where it may be");
  EXPECT_TRUE(mission.inform()->reason.starts_with("The robot has searched ")) << mission.inform()->reason;
  const auto number = mission.inform()->number;
  mission.inform_heard(number);
  robot_searches(seconds{30});  // it looks where they now know that it has looked
  EXPECT_EQ(mission.inform()->number, number);
}

}  // namespace
}  // namespace tandem
