#pragma once

#include <ceres/problem.h>
#include <ceres/solver.h>

namespace tandem {

/// For a problem of a few poses whose residuals and losses live on the caller's stack.
[[nodiscard]] inline ceres::Problem::Options borrowing_problem() {
  ceres::Problem::Options options;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.disable_all_safety_checks = true;
  return options;
}

/// For a few parameters and many residuals; one thread, so that equal input gives equal output.
[[nodiscard]] inline ceres::Solver::Options small_dense_solver(int most_iterations) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.max_num_iterations = most_iterations;
  options.function_tolerance = 1e-4;
  options.parameter_tolerance = 1e-5;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  return options;
}

}  // namespace tandem
