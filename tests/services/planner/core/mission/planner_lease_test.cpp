#include "services/planner/core/mission/planner_lease.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

TEST(PlannerLease, ASecondPlannerSaysWhoIsActive) {
  const PlannerIdentity self{"laptop1", 42};
  EXPECT_EQ(refusal_to_plan("r1", self, {}), "");
  EXPECT_EQ(refusal_to_plan("r1", self, {{self, "r1", false}, {{"laptop2", 7}, "r2", false}}), "");
  EXPECT_EQ(refusal_to_plan("r1", self, {{{"laptop2", 7}, "r1", false}}),
            "planner already active on host laptop2 pid 7");
}

TEST(PlannerLease, OfTwoThatStartAtOnceOneGivesWay) {
  const PlannerIdentity a{"laptop1", 42};
  const PlannerIdentity b{"laptop1", 43};
  EXPECT_EQ(refusal_to_plan("r1", a, {{b, "r1", true}}), "");
  EXPECT_NE(refusal_to_plan("r1", b, {{a, "r1", true}}), "");
}

}  // namespace
}  // namespace tandem
