#include "bench/planning/scores/frozen_score.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bench/planning/instance/instance_world.hpp"
#include "bench/planning/instance/scenario_file.hpp"
#include "bench/planning/loop/first_plan.hpp"
#include "bench/planning/records/json_lines.hpp"
#include "services/common/config.hpp"
#include "services/common/file_io.hpp"
#include "services/planner/core/planners/registry.hpp"

namespace tandem::bench {
namespace {

const std::filesystem::path kScenarios = std::filesystem::path{TANDEM_SOURCE_DIR} / "bench/planning/scenarios";

/// Also what the arithmetic of another build may do to a figure.
constexpr double kSame_s = 1e-6;

FrozenScore kept(const FrozenScore::Key& key) {
  for (const FrozenScore& score : read_lines<FrozenScore>(kScenarios / "scores.jsonl")) {
    if (score.key == key) return score;
  }
  ADD_FAILURE() << "no score is kept of " << key.planner << " on " << key.scenario;
  return {};
}

TEST(FrozenScore, TheScenariosAreTheInstancesThatTheirNamesSay) {
  for (const std::string& scenario : frozen_scenarios(kScenarios)) {
    const RunKey run = frozen_score_request(scenario, "tandem").run.key;
    EXPECT_EQ(read_file(kScenarios / (scenario + ".json")), scenario_json(instance_of(run.family, run.seed)))
        << scenario << ": tandem-bench-planning freeze writes it anew, scores --write the scores";
  }
}

TEST(FrozenScore, EveryPlannerHasAScoreOnEveryScenario) {
  const auto scores = read_lines<FrozenScore>(kScenarios / "scores.jsonl");
  ASSERT_EQ(scores.size(), frozen_scenarios(kScenarios).size() * planner_names().size());
  for (const std::string& scenario : frozen_scenarios(kScenarios)) {
    for (const std::string& planner : planner_names()) {
      const FrozenScore score = kept({scenario, planner});
      EXPECT_GE(score.search_s, score.search_bound_s) << scenario << " " << planner;
      EXPECT_GE(score.plan_s, score.plan_bound_s) << scenario << " " << planner;
      EXPECT_EQ(score.rollouts, frozen_score_request(scenario, planner).run.budget.rollouts) << planner;
    }
  }
}

// A difference here means that a planner plans otherwise than when the scores were made: scores --write makes them
// anew.
TEST(FrozenScore, ASearchScoresWhatIsKept) {
  const FrozenScore now = made_frozen_score(frozen_score_request("S1u_1", "nearest_unseen"));
  const FrozenScore then = kept(now.key);
  EXPECT_NEAR(now.search_s, then.search_s, kSame_s);
  EXPECT_NEAR(now.search_bound_s, then.search_bound_s, kSame_s);
  EXPECT_NEAR(now.search_left, then.search_left, 1e-9);
  EXPECT_EQ(now.plans, then.plans);
}

TEST(FrozenScore, APlanOfOursScoresWhatIsKept) {
  const FrozenScoreRequest request = frozen_score_request("S1x_1", "tandem");
  const PlanningInstance instance = instance_of(request.run.key.family, request.run.key.seed);
  const auto world = world_of(instance);
  const std::vector<double> prior = prior_mass(*world, instance);
  while (world->prepare_next()) {
  }
  const SearchProblem problem = problem_at_start(instance, *world, prior);
  const auto planner = make_planner("tandem");
  Rng rng{request.run.key.planner_seed};
  planner->begin(problem, rng.fork());
  planner->run(request.run.budget.rollouts.value_or(0), [] { return false; });
  const JointPlan plan = planner->best();
  const FrozenScore then = kept(request.key);
  EXPECT_NEAR(plan.forecast.expected_time_s, then.plan_s, kSame_s);
  EXPECT_NEAR(planner->lower_bound_s(), then.plan_bound_s, kSame_s);
}

TEST(FrozenScore, AnotherProgramIsToldATime) {
  const FrozenScoreRequest request = frozen_score_request("S1u4_1", "exec:true");
  EXPECT_EQ(request.run.key, (RunKey{"S1u4", 1, "exec:true", "100ms", 1}));
  EXPECT_FALSE(request.run.budget.rollouts);
  EXPECT_EQ(frozen_score_request("S1u4_1", "tandem:moves=0").run.budget.rollouts,
            frozen_score_request("S1u4_1", "tandem").run.budget.rollouts);
  EXPECT_THROW((void)frozen_score_request("S1u4", "tandem"), ConfigError);
}

TEST(FrozenScore, TheTableBeginsWithTheBest) {
  const auto score = [](const std::string& scenario, const std::string& planner, double search_s) {
    FrozenScore one;
    one.key = {scenario, planner};
    one.search_s = search_s;
    one.search_bound_s = 8.0;
    return one;
  };
  const std::vector<FrozenScore> scores{score("A_1", "slow", 20.0), score("B_1", "slow", 80.0),
                                        score("A_1", "ours", 10.0), score("B_1", "ours", 10.0),
                                        score("A_1", "fast", 5.0)};
  EXPECT_EQ(score_table(scores, "ours"),
            "E[T] of the search, s                  A_1       B_1   / ours\n"
            "fast                                  5.00         -   0.500\n"
            "ours                                 10.00     10.00   1.000\n"
            "slow                                 20.00     80.00   4.000\n"  // the mean of 2 and 8
            "nobody can beat                       8.00      8.00\n");
}

}  // namespace
}  // namespace tandem::bench
