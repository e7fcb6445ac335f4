#include "services/planner/core/planners/heeding_rejections.hpp"

#include <gtest/gtest.h>

#include "services/planner/core/baselines/greedy_planner.hpp"
#include "services/planner/core/planners/peers.hpp"
#include "services/planner/core/planners/registry.hpp"
#include "tests/services/planner/support/search_corridor.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

class PeerWithRejections : public ::testing::TestWithParam<std::string> {};

std::vector<std::string> peer_names() {
  std::vector<std::string> names;
  for (const auto& [name, make] : peers()) names.push_back(name);
  return names;
}

TEST_P(PeerWithRejections, ProposesNoRejectedPlanAgain) {
  SearchCase search(empty_room(12, 10), {6, 5}, {test_robot(), test_person()});
  search.problem.horizon_s = 40.0;
  const auto planner = make_planner(GetParam());
  for (int round = 0; round < 3; ++round) {
    const JointPlan plan = plan_with(*planner, search.problem, 20, 1);
    for (const auto& rejected : search.problem.rejected) EXPECT_FALSE(is_like(plan.paths, rejected)) << round;
    EXPECT_LT(plan.value_s, kRejectedPenalty_s);
    EXPECT_GT(plan.forecast.probability_found, 0.1);
    search.problem.rejected.push_back(plan.paths);
  }
}

TEST_P(PeerWithRejections, IsTheSameHoweverItsRolloutsAreCut) {
  SearchCase search(empty_room(12, 10), {6, 5}, {test_robot(), test_person()});
  search.problem.horizon_s = 40.0;
  const auto planner = make_planner(GetParam());
  search.problem.rejected.push_back(plan_with(*planner, search.problem, 20, 1).paths);
  const JointPlan whole = plan_with(*planner, search.problem, 20, 1);
  planner->begin(search.problem, Rng{1});
  for (int i = 0; i < 4; ++i) planner->run(5, {});
  EXPECT_EQ(planner->best().value_s, whole.value_s);
}

INSTANTIATE_TEST_SUITE_P(EachByName, PeerWithRejections, ::testing::ValuesIn(peer_names()),
                         [](const auto& named) { return named.param; });

TEST(HeedingRejections, TakesTheSecondChoiceAtTheFirstStep) {
  // From 4.75 m: 0.8 lies 5.5 m to the right, 0.2 lies 2 m to the left; per second 0.15 against 0.1.
  SearchCase search = corridor(1);
  place_mass(search, 2.75, 0.2, 10.25, 0.8);
  HeedingRejections planner(std::make_unique<GreedyPlanner>(GreedyOptions{}));
  const JointPlan first = plan_with(planner, search.problem, 0, 1);
  EXPECT_GT(pose_at(first.paths[0], 2.0).position().x(), 6.0);
  search.problem.rejected.push_back(first.paths);
  const JointPlan second = plan_with(planner, search.problem, 0, 1);
  EXPECT_LT(pose_at(second.paths[0], 2.0).position().x(), 4.0);
  EXPECT_DOUBLE_EQ(second.forecast.probability_found, 1.0);  // the greater part is looked for afterwards
}

/// Greedy, and how often it has begun.
class CountedGreedy final : public Planner {
 public:
  explicit CountedGreedy(int& begun) : begun_(begun) {}
  void begin(const SearchProblem& problem, Rng rng) override {
    ++begun_;
    greedy_.begin(problem, rng);
  }
  void run(int rollouts, const std::function<bool()>& stop) override { greedy_.run(rollouts, stop); }
  [[nodiscard]] int rollouts() const override { return greedy_.rollouts(); }
  [[nodiscard]] JointPlan best() override { return greedy_.best(); }

 private:
  int& begun_;
  GreedyPlanner greedy_{GreedyOptions{}};
};

TEST(HeedingRejections, BeginsNoOftenerThanItMust) {
  SearchCase search(empty_room(12, 10), {6, 5}, {test_robot(), test_person()});
  int begun = 0;
  HeedingRejections planner(std::make_unique<CountedGreedy>(begun));
  search.problem.rejected.push_back(plan_with(planner, search.problem, 0, 1).paths);
  EXPECT_EQ(begun, 1);
  (void)plan_with(planner, search.problem, 0, 1);
  EXPECT_LE(begun, 1 + 1 + 2 + 1);  // as it is, with a step of each member, with the better one again
}

TEST(HeedingRejections, WhereThereIsOnlyOneWayTheRejectedPlanComesOut) {
  SearchCase search(empty_room(2, 1), {1.5, 1.0}, {test_person()});
  HeedingRejections planner(std::make_unique<GreedyPlanner>(GreedyOptions{}));
  search.problem.rejected.push_back(plan_with(planner, search.problem, 0, 1).paths);
  const JointPlan again = plan_with(planner, search.problem, 0, 1);
  EXPECT_EQ(again.paths.size(), 1U);
  EXPECT_GE(again.value_s, kRejectedPenalty_s);  // and says so
}

TEST(HeedingRejections, IsThePlannerItselfWhileNothingIsRejected) {
  SearchCase search = corridor(2);
  GreedyPlanner greedy({});
  HeedingRejections heeding(std::make_unique<GreedyPlanner>(GreedyOptions{}));
  EXPECT_EQ(plan_with(greedy, search.problem, 0, 1).value_s, plan_with(heeding, search.problem, 0, 1).value_s);
  EXPECT_FALSE(
      HeedingRejections(std::make_unique<GreedyPlanner>(GreedyOptions{.mates = Mates::Independent})).shares_looks());
}

}  // namespace
}  // namespace tandem
