#include "services/map_builder/core/pose_graph.hpp"

#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <Eigen/Cholesky>
#include <deque>

#include "services/localization/core/solver_setup.hpp"
#include "services/localization/core/window_residuals.hpp"

namespace tandem {
namespace {

Eigen::Vector3d parameters_of(const Pose2& pose) {
  return {pose.x, pose.y, pose.heading};
}

ceres::Solver::Options sparse_solver(int most_iterations) {
  ceres::Solver::Options options = small_dense_solver(most_iterations);
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.function_tolerance = 1e-5;
  options.parameter_tolerance = 1e-8;
  return options;
}

}  // namespace

Eigen::Matrix3d root_information_in_a(const Pose2& a_from_b, const Eigen::Matrix3d& information_in_b) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  const double c = std::cos(a_from_b.heading);
  const double s = std::sin(a_from_b.heading);
  turn.topLeftCorner<2, 2>() << c, -s, s, c;
  const Eigen::Matrix3d information =
      turn * information_in_b * turn.transpose() + 1e-6 * Eigen::Matrix3d::Identity();  // never singular
  return information.llt().matrixU();
}

double deviations_off(const PoseEdge& edge, std::span<const Pose2> poses) {
  const Eigen::Vector3d a = parameters_of(poses[edge.from]);
  const Eigen::Vector3d b = parameters_of(poses[edge.to]);
  const double* parameters[] = {a.data(), b.data()};
  Eigen::Vector3d residual;
  RelativePoseResidual{edge.from_pose_to_pose, edge.root_information}.Evaluate(parameters, residual.data(), nullptr);
  return residual.norm();
}

void optimise(std::vector<Pose2>& poses, std::span<const PoseEdge> edges, Weighting weighting, int most_iterations) {
  if (poses.size() < 2 || edges.empty()) return;
  std::vector<Eigen::Vector3d> parameters;
  parameters.reserve(poses.size());
  for (const Pose2& pose : poses) parameters.push_back(parameters_of(pose));

  std::deque<RelativePoseResidual> residuals;  // a cost function does not move
  std::deque<ceres::CauchyLoss> losses;
  ceres::Problem problem{borrowing_problem()};
  for (const PoseEdge& edge : edges) {
    const bool robust = weighting == Weighting::Robust && edge.loss > 0.0;
    problem.AddResidualBlock(&residuals.emplace_back(edge.from_pose_to_pose, edge.root_information),
                             robust ? &losses.emplace_back(edge.loss) : nullptr, parameters[edge.from].data(),
                             parameters[edge.to].data());
  }
  if (problem.HasParameterBlock(parameters.front().data())) {
    problem.SetParameterBlockConstant(parameters.front().data());
  }
  ceres::Solver::Summary summary;
  ceres::Solve(sparse_solver(most_iterations), &problem, &summary);
  for (std::size_t i = 1; i < poses.size(); ++i) {
    poses[i] = {parameters[i].x(), parameters[i].y(), wrap_to_pi(parameters[i].z())};
  }
}

}  // namespace tandem
