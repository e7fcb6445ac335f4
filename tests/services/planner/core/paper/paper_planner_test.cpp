#include "services/planner/core/paper/paper_planner.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/services/planner/support/search_corridor.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

/// A hall of 16 m x 10 m with a wall that juts in.
SearchCase hall(std::vector<Searcher> searchers) {
  std::vector<std::string> drawing(22, "#" + std::string(32, '.') + "#");
  drawing.front() = drawing.back() = std::string(34, '#');
  for (std::size_t row = 1; row < 13; ++row) drawing[row][16] = '#';
  return {room(drawing), {3, 3}, std::move(searchers)};
}

/// Sees what is near at first sight.
Searcher walker(double speed_mps) {
  Searcher agent = test_person();
  agent.speed_mps = speed_mps;
  agent.view_max_m = 2.0;
  agent.detection_rate_per_s = std::numeric_limits<double>::infinity();
  return agent;
}

PaperOptions small(PaperObjective objective = PaperObjective::DetectedMass) {
  PaperOptions options;
  options.trees.nodes = 200;
  options.trees.goal_trees = 3;
  options.trees.goal_nodes = 20;
  options.objective = objective;
  return options;
}

TEST(PaperPlanner, T19WithoutAnyRolloutTheEndStatesGiveAPlan) {
  SearchCase search = hall({walker(0.5), walker(0.75)});
  PaperPlanner planner(small());
  const JointPlan plan = plan_with(planner, search.problem, 0, 1);
  EXPECT_GT(plan.paths[0].duration_s(), 5.0);
  EXPECT_GT(plan.forecast.probability_found, 0.3);
}

TEST(PaperPlanner, T20MoreRolloutsNeverGiveALesserReward) {
  SearchCase search = hall({walker(0.5), walker(0.75)});
  for (const PaperObjective objective : {PaperObjective::DetectedMass, PaperObjective::ExpectedTime}) {
    PaperPlanner planner(small(objective));
    planner.begin(search.problem, Rng{3});
    double last = planner.best_reward();
    for (int i = 0; i < 20; ++i) {
      planner.run(50, {});
      EXPECT_GE(planner.best_reward(), last);
      last = planner.best_reward();
    }
  }
}

TEST(PaperPlanner, T20ARewardIsAtMostTheSumOfWhatIsPromisedToEachAlone) {
  SearchCase search = hall({walker(0.5), walker(0.75)});
  PaperPlanner planner(small());
  (void)plan_with(planner, search.problem, 500, 2);
  EXPECT_LE(planner.best_reward(), planner.actions(0)[0].bound + planner.actions(1)[0].bound + 1e-9);
  EXPECT_LE(planner.best_reward(), 1.0);
}

TEST(PaperPlanner, T20EqualSeedAndRolloutsGiveTheSamePlanBitForBitHoweverTheyAreCut) {
  SearchCase search = hall({walker(0.5), walker(0.75)});
  PaperPlanner whole(small());
  const JointPlan a = plan_with(whole, search.problem, 300, 9);
  PaperPlanner pieces(small());
  pieces.begin(search.problem, Rng{9});
  for (int i = 0; i < 10; ++i) pieces.run(30, {});
  const JointPlan b = pieces.best();
  EXPECT_EQ(pieces.rollouts(), 300);
  EXPECT_EQ(a.forecast.expected_time_s, b.forecast.expected_time_s);
  for (std::size_t m = 0; m < 2; ++m) {
    ASSERT_EQ(a.paths[m].points.size(), b.paths[m].points.size());
    for (std::size_t i = 0; i < a.paths[m].points.size(); ++i) {
      EXPECT_EQ(a.paths[m].points[i].point_in_map, b.paths[m].points[i].point_in_map);
    }
  }
}

TEST(PaperPlanner, ItsRewardIsTheProbabilityOfFindingWithinThePlan) {
  SearchCase search = hall({walker(0.5), walker(0.75)});
  PaperPlanner planner(small());
  const JointPlan plan = plan_with(planner, search.problem, 300, 4);
  EXPECT_NEAR(planner.best_reward(), plan.forecast.probability_found, 1e-9);
}

TEST(PaperPlanner, CorrectedItGoesToTheLikelyRoomFirst) {
  SearchCase search = corridor(1);
  place_mass(search, 2.75, 0.2, 10.25, 0.8);
  PaperPlanner planner(small(PaperObjective::ExpectedTime));
  EXPECT_GT(pose_at(plan_with(planner, search.problem, 300, 4).paths[0], 4.0).x, 7.0);
}

TEST(PaperPlanner, T17AFixedGoalEndsItsMembersPath) {
  SearchCase search = hall({walker(0.5), walker(0.75)});
  const Vector2d corner{15.5, 9.5};
  search.problem.members[1].goal = corner;
  PaperPlanner planner(small());
  const JointPlan plan = plan_with(planner, search.problem, 100, 1);
  EXPECT_LE((plan.paths[1].points.back().point_in_map - corner).norm(), 0.5);
}

TEST(PaperPlanner, ARejectedPlanIsNotProposedAgain) {
  SearchCase search = hall({walker(0.5), walker(0.75)});
  for (int i = 0; i < 3; ++i) {
    PaperPlanner planner(small());
    const JointPlan plan = plan_with(planner, search.problem, 300, 1);
    for (const auto& other : search.problem.rejected) EXPECT_FALSE(is_like(plan.paths, other)) << "after " << i;
    search.problem.rejected.push_back(plan.paths);
  }
}

TEST(PaperPlanner, ACommittedPathIsWalkedFirst) {
  SearchCase search = hall({walker(0.5), walker(0.75)});
  search.problem.members[0].committed = {{{0.0, {3, 3}}, {4.0, {5, 3}}}};
  PaperPlanner planner(small());
  const JointPlan plan = plan_with(planner, search.problem, 100, 1);
  EXPECT_NEAR((pose_at(plan.paths[0], 2.0).position() - Vector2d{4, 3}).norm(), 0.0, 1e-9);
  EXPECT_NEAR((pose_at(plan.paths[0], 4.0).position() - Vector2d{5, 3}).norm(), 0.0, 1e-9);
  EXPECT_GT(plan.paths[0].duration_s(), 6.0);
}

TEST(PaperPlanner, WhereItsTreesSeeNothingNewItGoesToTheNearestUnseen) {
  SearchCase search = hall({walker(0.5)});
  auto& mass = search.problem.masses.front();
  std::fill(mass.begin(), mass.end(), 0.0);
  mass[static_cast<std::size_t>(*search.world().area().cell_at(Vector2d{15.25, 1.25}))] = 1.0;
  PaperOptions options = small();
  options.trees.nodes = 3;  // far from there
  options.trees.goal_trees = 0;
  PaperPlanner planner(options);
  EXPECT_NEAR(plan_with(planner, search.problem, 10, 1).forecast.probability_found, 1.0, 1e-9);
}

TEST(PaperPlanner, ItsPlansAreWalkedUntilABranchEnds) {
  EXPECT_FALSE(PaperPlanner(small()).replans_under_way());
}

TEST(PaperPlanner, T18AMemberThatCanGoNowhereWaitsAndTheOtherGoesOn) {
  Searcher stuck = walker(0.5);
  stuck.radius_m = 1.9;  // fits hardly anywhere
  SearchCase search = hall({walker(0.75), stuck});
  PaperPlanner planner(small());
  EXPECT_GT(plan_with(planner, search.problem, 10, 1).paths[0].duration_s(), 10.0);
}

}  // namespace
}  // namespace tandem
