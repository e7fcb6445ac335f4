#include "services/cli/plan/plan_run.hpp"

#include <gtest/gtest.h>

#include "services/common/config.hpp"

namespace tandem::cli {
namespace {

PlanningScenario search_from(double x_m, double y_m) {
  return parse_planning_scenario(R"({
    "room": {"width_m": 6, "height_m": 4, "boxes": [{"min": [4, 0], "max": [6, 4]}]},
    "agents": [{"id": "person", "kind": "person", "start": [)" +
                                     std::to_string(x_m) + ", " + std::to_string(y_m) + R"(, 0]}],
    "search": {}, "horizon_s": 30})",
                                 "test.json");
}

TEST(PlanRun, NoRolloutsIsTheFirstPlan) {
  const auto planned = plan_scenario(search_from(1.0, 1.0), {.rollouts = 0}, [](double) { return true; });
  EXPECT_EQ(planned.rollouts, 0);
  EXPECT_EQ(std::get<PlannedSearch>(planned.result).plan.paths.size(), 1U);
}

TEST(PlanRun, WhoSaysNoGetsTheBestPlanSoFar) {
  const auto planned = plan_scenario(search_from(1.0, 1.0), {.rollouts = 1'000'000}, [](double) { return false; });
  EXPECT_LT(planned.rollouts, 100);
  EXPECT_EQ(std::get<PlannedSearch>(planned.result).plan.paths.size(), 1U);
}

TEST(PlanRun, WhatIsFoundGrowsToWhatIsForecast) {
  const auto planned = plan_scenario(search_from(1.0, 1.0), {.rollouts = 20}, [](double) { return true; });
  const auto& search = std::get<PlannedSearch>(planned.result);
  ASSERT_EQ(search.found.size(), 61U);  // 30 s in steps of 0.5 s, and the start
  EXPECT_EQ(search.found.front(), 0.0);
  EXPECT_TRUE(std::ranges::is_sorted(search.found));
  EXPECT_NEAR(search.found.back(), search.plan.forecast.probability_found, 1e-9);
}

TEST(PlanRun, WhoCannotMoveWhereTheyStartIsNamed) {
  try {
    (void)plan_scenario(search_from(5.0, 2.0), {.rollouts = 0}, [](double) { return true; });
    FAIL() << "in a box";
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string{error.what()}.find("agents: "), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace tandem::cli
