#include "bench/planning/report/campaign.hpp"

#include <gtest/gtest.h>

#include <algorithm>

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

TEST(Campaign, SeedsAndAblationsAreTheCallers) {
  const Campaign campaign = campaign_of({.rows = {1}, .first_seed = 1000001, .ablations = {"eligible=4"}});
  EXPECT_TRUE(std::ranges::all_of(campaign.runs, [](const RunRequest& run) { return run.key.seed > 1000000; }));
  EXPECT_TRUE(
      std::ranges::any_of(campaign.runs, [](const RunRequest& run) { return run.key.planner == "tandem:eligible=4"; }));
}

}  // namespace
}  // namespace tandem::bench
