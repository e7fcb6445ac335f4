#include "bench/planning/report/results.hpp"

#include <gtest/gtest.h>

#include "bench/planning/report/report.hpp"
#include "bench/planning/report/rows.hpp"

namespace tandem::bench {
namespace {

RunRecord run(std::uint64_t seed, const std::string& planner, double expected_time_s) {
  RunRecord record;
  record.key = {"S1u", seed, planner, "200ms", 1};
  record.expected_time_s = expected_time_s;
  record.overlap = planner == "paper" ? 1.0 : 0.4;
  return record;
}

FirstPlanRecord plan(std::uint64_t seed, const std::string& planner, std::vector<double> values_s, double exact_s) {
  FirstPlanRecord record;
  record.key = {"S0m", seed, planner, 1};
  record.budgets_ms = {100.0, 1000.0};
  record.values_s = std::move(values_s);
  record.bounds_s = {8.0, 8.0};
  record.rollouts = {1, 2};
  record.exact_s = exact_s;
  record.exact_proven = exact_s > 0.0;
  return record;
}

Results some_results() {
  Results results;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    results.runs.push_back(run(seed, "tandem", 70.0));
    results.runs.push_back(run(seed, "paper", 100.0));
  }
  results.runs.push_back(run(5, "tandem", 1.0));  // has no partner, so it does not count
  results.first_plans = {plan(1, "tandem", {10.5, 10.0}, 10.0), plan(2, "tandem", {10.0, 10.0}, 10.0),
                         plan(1, "greedy15", {12.0, 12.0}, 0.0)};
  return results;
}

const TargetLine& line_with(const std::vector<TargetLine>& lines, const std::string& text) {
  for (const TargetLine& line : lines) {
    if (line.target.find(text) != std::string::npos) return line;
  }
  throw std::runtime_error("no line says " + text);
}

TEST(Results, ComparesOnlyWhatBothHaveRun) {
  const PairedComparison comparison = some_results().compared_with("tandem", "paper", {"S1u"}, "200ms");
  EXPECT_EQ(comparison.instances, 4U);
  EXPECT_NEAR(comparison.ratio.value, 0.7, 1e-12);
}

TEST(Results, TheBestKnownIsThatOfAllPlannersAndTimes) {
  const Results results = some_results();
  EXPECT_DOUBLE_EQ(results.best_known("S0m").at(1), 10.0);
  EXPECT_NEAR(results.gaps_to_best("S0m", "greedy15", 1000.0).at(0), 0.2, 1e-12);
  EXPECT_NEAR(results.gaps_to_best("S0m", "tandem", 100.0).at(0), 0.05, 1e-12);
}

TEST(Results, GapsToTheOptimumNeedNoProofOfOnesOwn) {
  EXPECT_NEAR(some_results().exact_gaps({"S0m"}, "greedy15", 100.0).at(0), 0.2, 1e-12);
  EXPECT_NEAR(some_results().certified_gaps("S0m", "tandem", 1000.0).at(0), 0.25, 1e-12);
}

TEST(Results, ATargetIsMetByTheUpperEndOfTheInterval) {
  const auto lines = target_lines(some_results(), "200ms");
  EXPECT_EQ(line_with(lines, "S1u: E[T] at most 0.80 of `paper`").verdict, Verdict::Met);
  EXPECT_EQ(line_with(lines, "S1x: E[T] at most 0.80 of `paper`").verdict, Verdict::NotMeasured);
  EXPECT_EQ(line_with(lines, "overlap").verdict, Verdict::Met);      // 0.4 against half of 1.0
  EXPECT_EQ(line_with(lines, "S0: mean").verdict, Verdict::NotMet);  // 5 % and 0 %: 2.5 % in the mean
}

TEST(Results, AReportNamesItsFilesAndSaysWhatIsNotMet) {
  const auto files = report_files(some_results(), {"2026-01-02", "abc", "a machine", "a command"});
  ASSERT_TRUE(files.contains("REPORT.md"));
  EXPECT_NE(files.at("REPORT.md").find("**not met**"), std::string::npos);
  EXPECT_NE(files.at("REPORT.md").find("0.700 [0.700, 0.700]"), std::string::npos);
  EXPECT_TRUE(files.contains("anytime_S0m.svg"));
  EXPECT_EQ(files.at("runs.csv").substr(0, 11), "family,seed");
}

}  // namespace
}  // namespace tandem::bench
