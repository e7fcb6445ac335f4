#include "bench/planning/loop/run_plan.hpp"

#include <gtest/gtest.h>

#include "services/common/config.hpp"

namespace tandem::bench {
namespace {

TEST(RunPlan, ReadsSeedsAndBudgets) {
  EXPECT_EQ(parse_seeds("1:3,7"), (std::vector<std::uint64_t>{1, 2, 3, 7}));
  EXPECT_THROW((void)parse_seeds("1:x"), ConfigError);
  EXPECT_THROW((void)parse_seeds(""), ConfigError);
  const auto budgets = parse_budgets("50,300r");
  ASSERT_EQ(budgets.size(), 2U);
  EXPECT_DOUBLE_EQ(budgets[0].cpu_ms, 50.0);
  EXPECT_EQ(budgets[1].rollouts, 300);
}

TEST(RunPlan, TakesEachInstanceWithEachPlannerAndBudget) {
  const auto runs = all_runs({"S0m"}, {1, 2}, {"tandem", "tandem:eligible=4"}, parse_budgets("5r,10r"));
  EXPECT_EQ(runs.size(), 8U);
  EXPECT_EQ(runs.front().key, (RunKey{"S0m", 1, "tandem", "5rollouts", 1}));
}

}  // namespace
}  // namespace tandem::bench
