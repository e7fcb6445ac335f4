#include "bench/planning/oracles/lookout_model.hpp"

#include <gtest/gtest.h>

#include "bench/planning/instance/instance_world.hpp"
#include "bench/planning/loop/first_plan.hpp"
#include "services/planner/core/team/prepared_problem.hpp"

namespace tandem::bench {
namespace {

// The oracle's own account of what is seen when agrees with the objective that values plans.
TEST(LookoutModel, TheOptimumIsTheValueOfItsPlan) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const PlanningInstance instance = instance_of("S0m", seed);
    const auto world = world_of(instance);
    const SearchProblem problem = problem_at_start(instance, *world, prior_mass(*world, instance));
    const ExactPlan exact = exact_search(lookout_model(problem), 1e9, 3'000'000);
    ASSERT_TRUE(exact.proven) << "seed " << seed;
    const PreparedProblem prepared(problem);
    EXPECT_NEAR(prepared.plan(exact.places).forecast.expected_time_s, exact.expected_time_s, 1e-6) << "seed " << seed;
  }
}

}  // namespace
}  // namespace tandem::bench
