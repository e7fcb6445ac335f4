// Laws that every planner of the registry keeps (digest, section 3).
#include <gtest/gtest.h>

#include <cmath>

#include "services/planner/core/planners/registry.hpp"
#include "tests/services/planner/support/search_corridor.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr int kRollouts = 40;

class EveryPlanner : public ::testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] JointPlan plan(const SearchProblem& problem, std::uint64_t seed = 1) const {
    return plan_with(*make_planner(GetParam()), problem, kRollouts, seed);
  }
};

/// A hall with pillars, everywhere as likely as chance says: no two choices are worth the same.
SearchCase hall(std::uint64_t seed) {
  Rng rng{seed};
  std::vector<std::string> drawing(20, "#" + std::string(28, '.') + "#");
  drawing.front() = drawing.back() = std::string(30, '#');
  for (int pillar = 0; pillar < 8; ++pillar) drawing[1 + rng.index(12)][8 + rng.index(20)] = '#';
  SearchCase search(room(drawing), {2, 2}, {test_robot(), test_person()});
  for (double& mass : search.problem.masses.front()) mass *= rng.uniform();
  search.problem.horizon_s = 60.0;
  return search;
}

void expect_same(const JointPlan& a, const JointPlan& b, const std::string& what) {
  ASSERT_EQ(a.paths.size(), b.paths.size()) << what;
  for (std::size_t m = 0; m < a.paths.size(); ++m) {
    ASSERT_EQ(a.paths[m].points.size(), b.paths[m].points.size()) << what << ", member " << m;
    for (std::size_t i = 0; i < a.paths[m].points.size(); ++i) {
      EXPECT_EQ(a.paths[m].points[i].time_s, b.paths[m].points[i].time_s) << what;
      EXPECT_EQ(a.paths[m].points[i].point_in_map, b.paths[m].points[i].point_in_map) << what;
    }
  }
}

TEST_P(EveryPlanner, T24GoesTheSameRoutesHoweverTheMassesAreScaled) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    SearchCase search = hall(seed);
    const JointPlan as_it_is = plan(search.problem);
    const std::vector<double> mass = search.problem.masses.front();
    for (const double scale : {1e-6, 1e6}) {
      std::ranges::transform(mass, search.problem.masses.front().begin(), [&](double one) { return scale * one; });
      expect_same(plan(search.problem), as_it_is, "seed " + std::to_string(seed));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(EachByName, EveryPlanner, ::testing::ValuesIn(planner_names()),
                         [](const auto& named) { return named.param; });

}  // namespace
}  // namespace tandem
