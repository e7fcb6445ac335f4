#include "gateway/server/core/two_people.hpp"

#include <gtest/gtest.h>

namespace tandem::gateway {
namespace {

using protocol::Command;
using protocol::CommandKind;
using protocol::Point;

const Time kStart = from_stamp_ns(1'000'000'000'000);

Command command(CommandKind kind, std::optional<Point> at = {}) {
  Command one;
  one.kind = kind;
  one.point_in_map = at;
  return one;
}

TEST(TwoPeople, AreWhereTheySaidAndAsLongAgo) {
  TwoPeople people;
  EXPECT_FALSE(people.state_of("anna", kStart));
  people.note("anna", command(CommandKind::MyGoal, Point{9.0, 9.0}), kStart);
  EXPECT_FALSE(people.state_of("anna", kStart));  // a goal alone is no place
  people.note("anna", command(CommandKind::MyPose, Point{1.0, 2.0}), kStart);

  const auto anna = people.state_of("anna", kStart + from_seconds(4.0));
  ASSERT_TRUE(anna);
  EXPECT_EQ(anna->position, (Point{1.0, 2.0}));
  EXPECT_EQ(anna->goal, (Point{9.0, 9.0}));
  EXPECT_EQ(anna->source, "message");
  EXPECT_DOUBLE_EQ(anna->age_s, 4.0);
  EXPECT_FALSE(people.state_of("berta", kStart));

  people.note("anna", command(CommandKind::ClearMyGoal), kStart);
  EXPECT_FALSE(people.state_of("anna", kStart)->goal);
}

TEST(TwoPeople, SeeEachOtherAsPartners) {
  protocol::State state;
  state.person.emplace().position = {1.0, 2.0};
  state.partner.emplace().position = {3.0, 4.0};
  EXPECT_EQ(mirrored(state).person, state.partner);
  EXPECT_EQ(mirrored(state).partner, state.person);
  EXPECT_EQ(mirrored(mirrored(state)), state);
}

TEST(TwoPeople, HaveNoUseForWhatIsForARobot) {
  EXPECT_TRUE(is_between_people(CommandKind::MyPose));
  EXPECT_TRUE(is_between_people(CommandKind::Found));
  EXPECT_FALSE(is_between_people(CommandKind::RobotGoal));
  EXPECT_FALSE(is_between_people(CommandKind::Replan));
}

}  // namespace
}  // namespace tandem::gateway
