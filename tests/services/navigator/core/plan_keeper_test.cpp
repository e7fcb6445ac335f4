#include "services/navigator/core/plan_keeper.hpp"

#include <gtest/gtest.h>

namespace tandem::navigator {
namespace {

using Standing = PlanKeeper::Standing;

Time at(double time_s) {
  return from_stamp_ns(0) + from_seconds(1000.0 + time_s);
}

PlanNews news(const std::string& id, PlanState state, std::uint64_t sequence_number) {
  return {id, "S1", "planner@laptop", sequence_number, state, at(100.0), {{0.0, 0.0}, {1.0, 0.0}}};
}

TEST(PlanKeeper, ExecutesAPlanThatWasProposedAndThenAccepted) {
  PlanKeeper keeper{from_seconds(2.0)};
  EXPECT_EQ(keeper.standing(at(0.0), "S1"), Standing::None);
  keeper.receive(news("p1", PlanState::Proposed, 1), at(0.0));
  EXPECT_EQ(keeper.standing(at(0.1), "S1"), Standing::Proposed);
  keeper.receive(news("p1", PlanState::Accepted, 2), at(1.0));
  EXPECT_EQ(keeper.standing(at(1.1), "S1"), Standing::Executable);
}

TEST(PlanKeeper, APlanThatIsNotRepeatedIsDead) {
  PlanKeeper keeper{from_seconds(2.0)};
  keeper.receive(news("p1", PlanState::Accepted, 1), at(0.0));
  keeper.receive(news("p1", PlanState::Accepted, 2), at(1.0));
  EXPECT_EQ(keeper.standing(at(3.0), "S1"), Standing::Executable);
  EXPECT_EQ(keeper.standing(at(3.1), "S1"), Standing::Dead);
}

TEST(PlanKeeper, TheLastWordOfADeadPlannerIsNotExecuted) {
  PlanKeeper keeper{from_seconds(2.0)};
  keeper.receive(news("p1", PlanState::Accepted, 7), at(0.0));  // what a late joiner is given
  EXPECT_EQ(keeper.standing(at(0.1), "S1"), Standing::Unconfirmed);
  keeper.receive(news("p1", PlanState::Accepted, 8), at(1.0));
  EXPECT_EQ(keeper.standing(at(1.1), "S1"), Standing::Executable);
}

TEST(PlanKeeper, NeverExecutesAPlanOfAnotherSessionOrPastItsTime) {
  PlanKeeper keeper{from_seconds(2.0)};
  PlanNews plan = news("p1", PlanState::Accepted, 1);
  plan.valid_until = at(1.5);
  keeper.receive(plan, at(0.0));
  plan.sequence_number = 2;
  keeper.receive(plan, at(1.0));
  EXPECT_EQ(keeper.standing(at(1.2), "S2"), Standing::OtherSession);
  EXPECT_EQ(keeper.standing(at(1.2), "S1"), Standing::Executable);
  EXPECT_EQ(keeper.standing(at(1.6), "S1"), Standing::Expired);
}

TEST(PlanKeeper, ARejectedPlanIsDroppedAtOnce) {
  PlanKeeper keeper{from_seconds(2.0)};
  keeper.receive(news("p1", PlanState::Accepted, 1), at(0.0));
  keeper.receive(news("p1", PlanState::Superseded, 2), at(0.5));
  EXPECT_EQ(keeper.standing(at(0.6), "S1"), Standing::None);
}

TEST(PlanKeeper, TheAcceptedPlanGoesOnWhileTheNextIsProposed) {
  PlanKeeper keeper{from_seconds(2.0)};
  keeper.receive(news("p1", PlanState::Accepted, 1), at(0.0));
  keeper.receive(news("p1", PlanState::Accepted, 2), at(1.0));
  for (int second = 2; second <= 4; ++second) {  // the time a person has to say Replan
    keeper.receive(news("p2", PlanState::Proposed, static_cast<std::uint64_t>(second) + 1), at(second));
    EXPECT_EQ(keeper.plan()->id, "p1");
    EXPECT_EQ(keeper.standing(at(second + 0.9), "S1"), Standing::Executable);
  }
  EXPECT_EQ(keeper.standing(at(6.1), "S1"), Standing::Dead);  // the planner fell silent
  keeper.receive(news("p2", PlanState::Accepted, 6), at(6.2));
  EXPECT_EQ(keeper.plan()->id, "p2");
}

TEST(PlanKeeper, ASecondPlannerIsNotListenedToWhileTheFirstIsAlive) {
  PlanKeeper keeper{from_seconds(2.0)};
  keeper.receive(news("p1", PlanState::Accepted, 1), at(0.0));
  keeper.receive(news("p1", PlanState::Accepted, 2), at(1.0));
  PlanNews other = news("q1", PlanState::Accepted, 1);
  other.planner = "planner@elsewhere";
  keeper.receive(other, at(1.5));
  EXPECT_EQ(keeper.plan()->id, "p1");
  other.sequence_number = 2;
  keeper.receive(other, at(4.0));  // the first has been silent for 3 s
  EXPECT_EQ(keeper.plan()->id, "q1");
}

/// Hears the first planner at whole seconds, and another half a second later each time, while they last.
void hear_both(PlanKeeper& keeper, int first_s, int last_s, int other_until_s) {
  for (int second = first_s; second <= last_s; ++second) {
    const auto number = static_cast<std::uint64_t>(second) + 1;
    keeper.receive(news("p1", PlanState::Accepted, number), at(second));
    if (second > other_until_s) continue;
    PlanNews other = news("q1", PlanState::Accepted, number);
    other.planner = "planner@elsewhere";
    keeper.receive(other, at(second + 0.5));
  }
}

TEST(PlanKeeper, X5OfTwoPlannersThatGoOnNeitherIsExecuted) {
  PlanKeeper keeper{from_seconds(2.0)};
  hear_both(keeper, 0, 2, 2);
  EXPECT_EQ(keeper.standing(at(2.6), "S1"), Standing::TwoPlanners);
  EXPECT_EQ(keeper.planner(), "planner@laptop");
  EXPECT_EQ(keeper.rival(at(2.6)), "planner@elsewhere");

  hear_both(keeper, 3, 6, 2);  // the second ends: 2 s later the first alone is there
  EXPECT_EQ(keeper.standing(at(4.4), "S1"), Standing::TwoPlanners);
  EXPECT_EQ(keeper.standing(at(4.6), "S1"), Standing::Executable);
  EXPECT_EQ(keeper.rival(at(4.6)), "");
}

TEST(PlanKeeper, TheLastWordOfAnotherPlannerStopsNothing) {
  PlanKeeper keeper{from_seconds(2.0)};
  hear_both(keeper, 0, 3, 0);  // the other is heard once, as a late joiner hears one that is dead
  for (const double time_s : {0.6, 1.1, 2.1}) EXPECT_NE(keeper.standing(at(time_s), "S1"), Standing::TwoPlanners);
}

TEST(PlanKeeper, APlannerThatWasStartedAgainIsNoSecondOne) {
  PlanKeeper keeper{from_seconds(2.0)};
  hear_both(keeper, 0, 2, -1);  // the last of the first life comes at 2
  PlanNews again = news("q1", PlanState::Accepted, 1);
  again.planner = "planner@laptop/2";
  for (const double time_s : {2.5, 3.5, 4.5, 5.5}) {
    ++again.sequence_number;
    keeper.receive(again, at(time_s));
    EXPECT_NE(keeper.standing(at(time_s), "S1"), Standing::TwoPlanners) << time_s;
  }
  EXPECT_EQ(keeper.standing(at(5.6), "S1"), Standing::Executable);
}

}  // namespace
}  // namespace tandem::navigator
