#include "bench/planning/report/campaign.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bench/planning/report/rows.hpp"
#include "services/planner/core/planners/registry.hpp"

namespace tandem::bench {
namespace {

TEST(Campaign, AQuickOneIsAPartOfTheWhole) {
  const Campaign quick = campaign_of({.quick = true});
  const Campaign whole = campaign_of({});
  EXPECT_LT(quick.runs.size(), whole.runs.size());
  for (const RunRequest& run : quick.runs) {
    EXPECT_TRUE(std::ranges::any_of(whole.runs,
                                    [&](const RunRequest& other) {
                                      return other.key.family == run.key.family && other.key.seed == run.key.seed &&
                                             other.key.planner == run.key.planner;
                                    }))
        << run.key.family << " " << run.key.planner;
  }
}

TEST(Campaign, RowsPickWhatTheyNeed) {
  const Campaign speed = campaign_of({.rows = {8}});
  EXPECT_TRUE(speed.runs.empty());
  EXPECT_TRUE(speed.first_plans.empty());
  EXPECT_FALSE(speed.micro.empty());
}

TEST(Campaign, EachRunIsAskedForOnce) {
  Campaign whole = campaign_of({});
  std::vector<RunKey> keys;
  for (const RunRequest& run : whole.runs) keys.push_back(run.key);
  std::ranges::sort(keys);
  EXPECT_EQ(std::ranges::adjacent_find(keys), keys.end());
}

TEST(Campaign, KnowsEveryFamilyAndPlannerItAsksFor) {
  const Campaign whole = campaign_of({});
  for (const RunRequest& run : whole.runs) {
    EXPECT_NO_THROW((void)make_planner(run.key.planner.substr(0, run.key.planner.find('@')))) << run.key.planner;
    EXPECT_TRUE(std::ranges::any_of(families(), [&](const FamilySpec& f) { return f.name == run.key.family; }));
  }
}

TEST(Campaign, AWholeOneMeasuresEveryTarget) {
  const Campaign whole = campaign_of({});
  Results results;
  for (const RunRequest& request : whole.runs) {
    results.runs.emplace_back().key = request.key;
    results.runs.back().expected_time_s = 1.0;
  }
  for (const FirstPlanRequest& request : whole.first_plans) {
    FirstPlanRecord& plan = results.first_plans.emplace_back();
    plan.key = request.key;
    plan.first_plan_ms = 1.0;
    plan.budgets_ms = request.budgets_ms;
    plan.values_s.assign(request.budgets_ms.size(), 1.0);
    plan.bounds_s = plan.values_s;
    plan.exact_s = 1.0;
    plan.exact_proven = request.exact;
  }
  for (const MicroRequest& request : whole.micro) results.micro.emplace_back().key = request.key;
  for (const TaskRequest& request : whole.tasks) {
    results.tasks.emplace_back().key = request.key;
    results.tasks.back().optimum_proven = true;
  }
  for (const TargetLine& line : target_lines(results, "200ms")) {
    EXPECT_NE(line.verdict, Verdict::NotMeasured) << "row " << line.row << ": " << line.target;
  }
}

TEST(Campaign, SeedsAndAblationsAreTheCallers) {
  const Campaign campaign = campaign_of({.rows = {1}, .first_seed = 1000001, .ablations = {"eligible=4"}});
  EXPECT_TRUE(std::ranges::all_of(campaign.runs, [](const RunRequest& run) { return run.key.seed > 1000000; }));
  EXPECT_TRUE(
      std::ranges::any_of(campaign.runs, [](const RunRequest& run) { return run.key.planner == "tandem:eligible=4"; }));
}

}  // namespace
}  // namespace tandem::bench
