#include "services/planner/core/mission/plan_explanation.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

PlanFacts facts() {
  PlanFacts facts;
  facts.occasion = "first plan";
  facts.robot_way_m = 12.4;
  facts.person_way_m = 30.6;
  facts.probability_found = 0.64;
  facts.horizon_s = 120.0;
  facts.without_person_s = 91.2;
  return facts;
}

TEST(PlanExplanation, SaysWhoGoesHowFarAndWhatThatIsGoodFor) {
  EXPECT_EQ(
      explanation_of(facts()),
      "First plan. The robot goes 12 m, you go 31 m: found with 64 % within 120 s; if you stayed where you are it "
      "would take 91 s longer.");
}

TEST(PlanExplanation, SaysWhoseGoalsAreFixed) {
  PlanFacts fixed = facts();
  fixed.robot_goal_fixed = true;
  fixed.person_goal_fixed = true;
  fixed.without_person_s.reset();
  EXPECT_EQ(explanation_of(fixed),
            "First plan. The robot goes 12 m to the goal you gave it, you go 31 m to your goal: found with 64 % within "
            "120 s.");
}

TEST(PlanExplanation, LeavesOutAPersonWhoIsNotPlannedForAndAGainOfNothing) {
  PlanFacts alone = facts();
  alone.person_way_m.reset();
  alone.without_person_s.reset();
  EXPECT_EQ(explanation_of(alone), "First plan. The robot goes 12 m: found with 64 % within 120 s.");
  PlanFacts idle = facts();
  idle.robot_way_m = 0.0;
  idle.person_way_m = 0.0;
  idle.without_person_s = 0.0;
  EXPECT_EQ(explanation_of(idle), "First plan. The robot stays here, you stay here: found with 64 % within 120 s.");
}

}  // namespace
}  // namespace tandem
