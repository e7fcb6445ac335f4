#include "services/planner/core/planners/peers.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "services/common/config.hpp"
#include "services/planner/core/planners/registry.hpp"
#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

TEST(Peers, EachPlansForARobotAndAPerson) {
  SearchCase search(empty_room(8, 5), {2, 2}, {test_robot(), test_person()});
  for (const auto& [name, make] : peers()) {
    const auto planner = make_planner(name);
    const JointPlan plan = plan_with(*planner, search.problem, 20, 1);
    ASSERT_EQ(plan.paths.size(), 2U) << name;
    EXPECT_GT(plan.paths[1].duration_s(), 1.0) << name;
    EXPECT_GT(plan.forecast.probability_found, 0.05) << name;
    for (const TimedPath& path : plan.paths) {
      EXPECT_LE((path.points.front().point_in_map - Eigen::Vector2d{2, 2}).norm(), 1e-9) << name;
      for (std::size_t i = 1; i < path.points.size(); ++i) {
        EXPECT_GE(path.points[i].time_s, path.points[i - 1].time_s) << name;
      }
    }
  }
}

TEST(Peers, EachPlansForSeveralObjectsAndWithOthersUnderWay) {
  SearchCase search(empty_room(8, 5), {2, 2}, {test_robot(), test_person()});
  search.problem.masses.push_back(search.problem.masses.front());
  search.problem.members.pop_back();
  search.problem.others.push_back({1, 0.0, {{{0.0, {2, 2}}, {4.0, {5, 2}}}}});
  for (const auto& [name, make] : peers()) {
    const auto planner = make_planner(name);
    EXPECT_GT(plan_with(*planner, search.problem, 10, 1).paths[0].duration_s(), 1.0) << name;
  }
}

TEST(Peers, OptionsAreTakenByName) {
  EXPECT_NO_THROW((void)make_planner("paper:nodes=300,eligible=2,w=0.3,gamma=0.9,goal_trees=4,step_m=1.5"));
  EXPECT_NO_THROW((void)make_planner("greedy:exponent=1.25"));
  EXPECT_THROW((void)make_planner("paper:knots=300"), ConfigError);
}

}  // namespace
}  // namespace tandem
