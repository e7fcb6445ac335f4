#include "services/planner/core/planners/registry.hpp"

#include <gtest/gtest.h>

#include "services/common/config.hpp"
#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

TEST(Registry, EveryPlannerHasAPlanForTwoAtOnce) {
  SearchCase search(empty_room(8, 6), {3, 3}, {test_robot(), test_person()});
  for (const std::string& name : planner_names()) {
    const auto planner = make_planner(name);
    const JointPlan plan = plan_with(*planner, search.problem, 0, 1);
    ASSERT_EQ(plan.paths.size(), 2U) << name;
    EXPECT_GT(plan.forecast.probability_found, 0.0) << name;
  }
}

TEST(Registry, AnUnknownNameIsRefusedAndTheKnownOnesAreNamed) {
  try {
    (void)make_planner("fastest");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string{error.what()}.find("tandem"), std::string::npos);
  }
}

TEST(Registry, AnUnknownOptionIsRefused) {
  EXPECT_NO_THROW((void)make_planner("tandem:eligible=6"));
  EXPECT_THROW((void)make_planner("tandem:eligibel=6"), ConfigError);
  EXPECT_THROW((void)make_planner("tandem:eligible"), ConfigError);
}

}  // namespace
}  // namespace tandem
