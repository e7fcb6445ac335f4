#include "services/localization/core/solver_setup.hpp"

#include <ceres/autodiff_cost_function.h>
#include <ceres/loss_function.h>
#include <gtest/gtest.h>

namespace tandem {
namespace {

/// x^4 - 16: nothing at 2, and far from linear on the way there.
struct Quartic {
  template <typename T>
  bool operator()(const T* x, T* residual) const {
    residual[0] = x[0] * x[0] * x[0] * x[0] - T(16.0);
    return true;
  }
};

/// Solves from `x` on with cost and loss on the stack, as our callers do: the sanitizers see if they are deleted.
ceres::Solver::Summary solved(double& x, int most_iterations) {
  ceres::AutoDiffCostFunction<Quartic, 1, 1> cost{new Quartic, ceres::TAKE_OWNERSHIP};
  ceres::TrivialLoss loss;
  ceres::Problem problem{borrowing_problem()};
  problem.AddResidualBlock(&cost, &loss, &x);
  ceres::Solver::Summary summary;
  ceres::Solve(small_dense_solver(most_iterations), &problem, &summary);
  return summary;
}

TEST(SolverSetup, FindsTheLeast) {
  double x = 5.0;
  const auto summary = solved(x, 50);
  EXPECT_EQ(summary.termination_type, ceres::CONVERGENCE);
  EXPECT_NEAR(x, 2.0, 1e-3);
}

TEST(SolverSetup, StopsAfterSoManyIterations) {
  double x = 5.0;
  const auto summary = solved(x, 2);
  EXPECT_EQ(summary.termination_type, ceres::NO_CONVERGENCE);
  EXPECT_LE(summary.iterations.size(), 3U);  // and the start
  EXPECT_GT(x, 2.1);
}

TEST(SolverSetup, EqualInputGivesEqualOutput) {
  double once = 3.7;
  double again = 3.7;
  EXPECT_EQ(solved(once, 50).num_threads_used, 1);
  (void)solved(again, 50);
  EXPECT_EQ(once, again);
}

}  // namespace
}  // namespace tandem
