#include "services/localization/core/sliding_window.hpp"

#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

#include "services/localization/core/beams.hpp"
#include "services/localization/core/scan_residual.hpp"
#include "services/localization/core/solver_setup.hpp"
#include "services/localization/core/surface_normals.hpp"
#include "services/localization/core/window_residuals.hpp"

namespace tandem {
namespace {

constexpr double kFarM = 0.3;  ///< A guess this far from what the window expects is another place.
constexpr double kFarRad = 0.2;
constexpr double kFilterM = 0.05;  ///< The filter is no better than this: its particles weighed the same scan.
constexpr double kFilterRad = 0.05;
constexpr double kNewScanShare = 0.1;     ///< Weight of the newest scan in the mean deviation of beams.
constexpr double kLeastDeviation = 1e-3;  ///< No motion is known better [m, rad].

Pose2 pose_of(const Eigen::Vector3d& parameters) {
  return {parameters.x(), parameters.y(), wrap_to_pi(parameters.z())};
}

Eigen::Matrix3d root_information_of(const MotionDeviation& deviation) {
  return Eigen::Vector3d{deviation.forward_m, deviation.sideways_m, deviation.turn_rad}
      .cwiseMax(kLeastDeviation)
      .cwiseInverse()
      .asDiagonal();
}

/// A motion between two poses, linearised.
struct LinearMotion {
  LinearMotion(const RelativePoseResidual& residual, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const double* parameters[] = {a.data(), b.data()};
    double* jacobians[] = {by_a.data(), by_b.data()};
    residual.Evaluate(parameters, value.data(), jacobians);
  }
  using Jacobian = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  Jacobian by_a;
  Jacobian by_b;
  Eigen::Vector3d value;
};

/// The information that a motion holds about both poses.
Eigen::Matrix<double, 6, 6> information_of(const RelativePoseResidual& residual, const Eigen::Vector3d& a,
                                           const Eigen::Vector3d& b) {
  const LinearMotion linear{residual, a, b};
  Eigen::Matrix<double, 3, 6> both;
  both << linear.by_a, linear.by_b;
  return both.transpose() * both;
}

/// How a motion pulls at the second pose: the gradient of half its squared residual.
Eigen::Vector3d pull_of(const RelativePoseResidual& residual, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const LinearMotion linear{residual, a, b};
  return linear.by_b.transpose() * linear.value;
}

}  // namespace

RefinedPose SlidingWindow::add(const RefinedPose& filtered, std::span<const Eigen::Vector2d> endpoints_in_base,
                               const Pose2& motion, const MotionDeviation& deviation) {
  const Pose2& guess = filtered.map_from_base;
  if (!frames_.empty()) {
    const Pose2 expected = pose_of(frames_.back().pose) * motion;
    const bool far = (expected.position() - guess.position()).norm() > kFarM ||
                     std::abs(turn_between(expected.heading, guess.heading)) > kFarRad;
    if (far) restart();
  }
  if (frames_.empty()) {
    prior_ = guess;
    const Eigen::Vector3d least{kFilterM * kFilterM, kFilterM * kFilterM, kFilterRad * kFilterRad};
    prior_information_ = (filtered.covariance + Eigen::Matrix3d{least.asDiagonal()}).inverse();
    free_in_map_.setZero();
  } else {
    frames_.back().endpoints_in_base = thinned(frames_.back().endpoints_in_base, options_.older_beams);
    frames_.back().normals_in_base = thinned(frames_.back().normals_in_base, options_.older_beams);
  }
  frames_.push_back({{guess.x, guess.y, guess.heading},
                     {endpoints_in_base.begin(), endpoints_in_base.end()},
                     surface_normals(endpoints_in_base),
                     motion,
                     root_information_of(deviation)});
  solve();
  measure();
  const Eigen::MatrixXd covariance = information().inverse();
  RefinedPose result{pose_of(frames_.back().pose), covariance.bottomRightCorner<3, 3>()};
  result.covariance += options_.map_deviation_m * options_.map_deviation_m * measurements_.back().by_map;
  if (frames_.size() >= options_.scans) drop_oldest();
  return result;
}

void SlidingWindow::solve() {
  // Distances stay in metres; all else is scaled so that it is in units of the same deviation.
  const double unit_m = deviation_m_ / std::sqrt(options_.beam_weight);
  std::deque<ScanResidual> beams;  // a cost function does not move
  std::deque<RelativePoseResidual> motions;
  const Eigen::Matrix3d root = prior_information_.llt().matrixU();
  MarginalResidual prior{prior_, unit_m * root};
  ceres::CauchyLoss loss{options_.loss_m};

  ceres::Problem problem{borrowing_problem()};
  problem.AddResidualBlock(&prior, nullptr, frames_.front().pose.data());
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    Frame& frame = frames_[i];
    for (const Eigen::Vector2d& endpoint : frame.endpoints_in_base) {
      problem.AddResidualBlock(&beams.emplace_back(field_, endpoint), &loss, frame.pose.data());
    }
    if (i == 0) continue;
    problem.AddResidualBlock(&motions.emplace_back(frame.motion, unit_m * frame.root_information), nullptr,
                             frames_[i - 1].pose.data(), frame.pose.data());
  }

  ceres::Solver::Summary summary;
  ceres::Solve(small_dense_solver(8), &problem, &summary);
}

void SlidingWindow::measure() {
  measurements_.clear();
  for (const Frame& frame : frames_) {
    measurements_.push_back(scan_information(field_, frame.endpoints_in_base, frame.normals_in_base,
                                             pose_of(frame.pose), options_.loss_m, free_in_map_));
  }
  free_in_map_ = measurements_.back().free_in_map;
  const double newest_m = measurements_.back().deviation_m;
  if (newest_m > 0.0) deviation_m_ += kNewScanShare * (newest_m - deviation_m_);
}

Eigen::MatrixXd SlidingWindow::information() const {
  const auto size = static_cast<Eigen::Index>(3 * frames_.size());
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(size, size);
  all.topLeftCorner<3, 3>() = prior_information_;
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(3 * i);
    all.block<3, 3>(at, at) += measurements_[i].information;
    if (i == 0) continue;
    const RelativePoseResidual residual{frames_[i].motion, frames_[i].root_information};
    all.block<6, 6>(at - 3, at - 3) += information_of(residual, frames_[i - 1].pose, frames_[i].pose);
  }
  return all;
}

/// The oldest pose and all that is known of it alone becomes a prior of the next: a Schur complement.
void SlidingWindow::drop_oldest() {
  if (frames_.size() == 1) {  // a window of one scan: its pose is the prior, moved on when the next comes
    restart();
    return;
  }
  const Frame& next = frames_[1];
  const RelativePoseResidual residual{next.motion, next.root_information};
  Eigen::Matrix<double, 6, 6> both = information_of(residual, frames_[0].pose, next.pose);
  both.topLeftCorner<3, 3>() += prior_information_ + measurements_[0].information;
  const Eigen::Matrix3d gain = both.bottomLeftCorner<3, 3>() * both.topLeftCorner<3, 3>().inverse();
  const Eigen::Matrix3d left = both.bottomRightCorner<3, 3>() - gain * both.topRightCorner<3, 3>();
  prior_information_ = 0.5 * (left + left.transpose());
  // At the optimum only the motion pulls at the next pose: without the later scans it would lie where that is at rest.
  const Eigen::Vector3d mean =
      next.pose - prior_information_.ldlt().solve(pull_of(residual, frames_[0].pose, next.pose));
  prior_ = pose_of(mean);
  frames_.pop_front();
}

}  // namespace tandem
