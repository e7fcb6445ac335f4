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

}  // namespace
}  // namespace tandem::navigator
