#include "services/planner/core/acceptance/plan_acceptance.hpp"

#include <gtest/gtest.h>

#include "services/common/clock.hpp"

namespace tandem {
namespace {

using std::chrono::seconds;

class PlanAcceptanceTest : public ::testing::Test {
 protected:
  ManualClock clock{from_stamp_ns(1'000'000'000'000)};
  PlanAcceptance plan{seconds{3}};

  void propose() { plan.propose(clock.now(), clock.now() + seconds{60}); }
  PlanStanding standing() const { return plan.standing(clock.now()); }
};

TEST_F(PlanAcceptanceTest, IsAcceptedThreeSecondsAfterItsProposal) {
  EXPECT_EQ(standing(), PlanStanding::None);
  propose();
  clock.advance(from_seconds(2.999));
  EXPECT_EQ(standing(), PlanStanding::Proposed);
  EXPECT_FALSE(plan.may_execute(clock.now()));
  clock.advance(from_seconds(0.001));
  EXPECT_EQ(standing(), PlanStanding::Accepted);
  EXPECT_TRUE(plan.may_execute(clock.now()));
}

TEST_F(PlanAcceptanceTest, ReplanRejectsAProposalForGood) {
  propose();
  clock.advance(seconds{2});
  plan.replan(clock.now());
  clock.advance(seconds{10});
  EXPECT_EQ(standing(), PlanStanding::Rejected);
}

TEST_F(PlanAcceptanceTest, ReplanSupersedesAPlanUnderWay) {
  propose();
  clock.advance(seconds{5});
  plan.replan(clock.now());
  EXPECT_EQ(standing(), PlanStanding::Superseded);
}

TEST_F(PlanAcceptanceTest, IsNeverExecutedPastItsValidity) {
  propose();
  clock.advance(seconds{60});
  EXPECT_EQ(standing(), PlanStanding::Accepted);
  clock.advance(from_seconds(0.001));
  EXPECT_EQ(standing(), PlanStanding::Expired);
  plan.replan(clock.now());
  EXPECT_EQ(standing(), PlanStanding::Expired);
}

TEST_F(PlanAcceptanceTest, ANewProposalWaitsAnew) {
  propose();
  clock.advance(seconds{5});
  plan.withdraw();
  EXPECT_EQ(standing(), PlanStanding::Superseded);
  propose();
  EXPECT_EQ(standing(), PlanStanding::Proposed);
}

}  // namespace
}  // namespace tandem
