#include "bench/planning/loop/run_plan.hpp"

#include <gtest/gtest.h>

#include "services/common/config.hpp"
#include "services/common/file_io.hpp"

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
  const auto runs = all_runs({"S0m"}, {1, 2}, {"greedy", "greedy15"}, parse_budgets("5r,10r"));
  EXPECT_EQ(runs.size(), 8U);
  EXPECT_EQ(runs.front().key, (RunKey{"S0m", 1, "greedy", "5rollouts", 1}));
}

TEST(RunPlan, GoesOnWhereItWasLeftOff) {
  const auto file = std::filesystem::path(testing::TempDir()) / "tandem_run_plan_test.jsonl";
  std::filesystem::remove(file);
  const auto requests = all_runs({"S0m"}, {1, 2}, {"greedy15"}, parse_budgets("5r"));
  int made = 0;
  const auto count = [&](const RunRecord&, std::size_t) { ++made; };
  // Stopped after the first.
  const auto first = made_runs(requests, file, 1, count, [&] { return made == 1; });
  EXPECT_EQ(first.size(), 1U);
  const auto rest = made_runs(requests, file, 1, count, [] { return false; });
  EXPECT_EQ(made, 2);
  ASSERT_EQ(rest.size(), 2U);
  EXPECT_DOUBLE_EQ(rest.front().expected_time_s, first.front().expected_time_s);
  EXPECT_EQ(read_records(file).size(), 2U);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace tandem::bench
