#include "calibration/core/joint_calibration.hpp"

#include <ceres/autodiff_cost_function.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "calibration/core/median.hpp"
#include "calibration/core/robust_covariance.hpp"
#include "calibration/core/wheel_motion.hpp"

namespace tandem {
namespace {

constexpr int kRounds = 8;               ///< The steps are cut anew for the clock found, and the noise measured.
constexpr double kLoss = 3.0;            ///< Pairs off by more of their deviations count less and less.
constexpr double kMedianShare = 0.6745;  ///< of a normal deviation
const Eigen::Vector3d kLeastNoise{2e-4, 2e-4, 1e-4};
constexpr double kMostClockS = 1.0;

using Residual = ceres::AutoDiffCostFunction<MotionResidual, 3, 3, 3, 1>;

/// All unknowns; the laser as the place of the recorded base in the true one.
struct Unknowns {
  std::array<double, 3> wheels{1.0, 1.0, 1.0};
  std::array<double, 3> laser{};
  double delay_s = 0.0;  ///< on top of clock_s

  [[nodiscard]] std::array<const double*, 3> blocks() const { return {wheels.data(), laser.data(), &delay_s}; }
};

/// A pair whose wheels are known.
struct Term {
  const MotionPair* pair = nullptr;
  std::unique_ptr<Residual> residual;  ///< weighted
  std::unique_ptr<Residual> plain;
};

std::vector<Term> terms_of(const OdometryTrack& odometry, std::span<const MotionPair> pairs, double clock_s,
                           double half_track_m, const Eigen::Vector3d& noise) {
  std::vector<Term> terms;
  const Duration clock = from_seconds(clock_s);
  for (const MotionPair& pair : pairs) {
    const auto wheels = wheel_motion(odometry, pair.from + clock, pair.to + clock);
    if (!wheels) continue;
    const Eigen::Matrix3d covariance = pair.covariance + Eigen::Matrix3d{noise.cwiseAbs2().asDiagonal()};
    const Eigen::Matrix3d root = covariance.inverse().llt().matrixU();
    const auto residual = [&](const Eigen::Matrix3d& weight) {
      return std::make_unique<Residual>(new MotionResidual(*wheels, pair.motion, half_track_m, weight));
    };
    terms.push_back({&pair, residual(root), residual(Eigen::Matrix3d::Identity())});
  }
  return terms;
}

Eigen::Vector3d value_of(const Residual& residual, const Unknowns& unknowns) {
  Eigen::Vector3d value;
  const auto blocks = unknowns.blocks();
  residual.Evaluate(blocks.data(), value.data(), nullptr);
  return value;
}

Eigen::Vector3d spread_of(const std::vector<Term>& terms, const Unknowns& unknowns) {
  Eigen::Vector3d spread;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> sizes;
    for (const Term& term : terms) sizes.push_back(std::abs(value_of(*term.plain, unknowns)(axis)));
    spread(axis) = median(std::move(sizes)) / kMedianShare;
  }
  return spread;
}

/// What the wheels add to the noise of the scans.
Eigen::Vector3d noise_of(const std::vector<Term>& terms, const Eigen::Vector3d& spread) {
  Eigen::Vector3d noise;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> variances;
    for (const Term& term : terms) variances.push_back(term.pair->covariance(axis, axis));
    const double rest = spread(axis) * spread(axis) - median(std::move(variances));
    noise(axis) = std::max(kLeastNoise(axis), std::sqrt(std::max(0.0, rest)));
  }
  return noise;
}

void solve(const std::vector<Term>& terms, bool hold_wheels, Unknowns& unknowns) {
  ceres::Problem::Options borrowing;
  borrowing.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  borrowing.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem{borrowing};
  ceres::CauchyLoss loss{kLoss};
  for (const Term& term : terms) {
    problem.AddResidualBlock(term.residual.get(), &loss, unknowns.wheels.data(), unknowns.laser.data(),
                             &unknowns.delay_s);
  }
  if (hold_wheels) problem.SetParameterBlockConstant(unknowns.wheels.data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 50;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
}

/// The residual of a term with its derivatives by all unknowns that are not held.
WeighedResidual weighed(const Term& term, bool hold_wheels, const Unknowns& unknowns) {
  Eigen::Vector3d value;
  Eigen::Matrix<double, 3, 3, Eigen::RowMajor> by_wheels;
  Eigen::Matrix<double, 3, 3, Eigen::RowMajor> by_laser;
  Eigen::Vector3d by_delay;
  std::array<double*, 3> jacobians{by_wheels.data(), by_laser.data(), by_delay.data()};
  const auto blocks = unknowns.blocks();
  term.residual->Evaluate(blocks.data(), value.data(), jacobians.data());
  WeighedResidual result{.value = value, .jacobian = Eigen::MatrixXd(3, hold_wheels ? 4 : 7)};
  if (hold_wheels) {
    result.jacobian << by_laser, by_delay;
  } else {
    result.jacobian << by_wheels, by_laser, by_delay;
  }
  return result;
}

CalibrationCovariance covariance_of(const std::vector<Term>& terms, const CalibrationStart& start,
                                    const Unknowns& unknowns) {
  std::vector<WeighedResidual> residuals;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    residuals.push_back(weighed(terms[i], start.hold_wheels, unknowns));
    residuals.back().follows_the_last = i > 0 && terms[i].pair->from == terms[i - 1].pair->to;
  }
  const Eigen::MatrixXd found = robust_covariance(residuals, kLoss);
  CalibrationCovariance covariance = CalibrationCovariance::Zero();
  covariance.bottomRightCorner(found.rows(), found.cols()) = found;
  // base_from_laser = e * (what was recorded): a turn of e moves the laser.
  const Eigen::Vector2d arm = Pose2{0.0, 0.0, unknowns.laser[2]} * start.base_from_laser.position();
  CalibrationCovariance by_unknowns = CalibrationCovariance::Identity();
  by_unknowns(3, 5) = -arm.y();
  by_unknowns(4, 5) = arm.x();
  return by_unknowns * covariance * by_unknowns.transpose();
}

std::vector<PairResidual> residuals_of(const std::vector<Term>& before, const std::vector<Term>& after,
                                       const Unknowns& unknowns) {
  std::vector<PairResidual> residuals;
  auto first = before.begin();
  for (const Term& term : after) {
    while (first != before.end() && first->pair->from < term.pair->from) ++first;
    if (first == before.end()) break;
    if (first->pair != term.pair) continue;
    const double square = value_of(*term.residual, unknowns).squaredNorm();
    residuals.push_back({.from = term.pair->from,
                         .way_m = term.pair->motion.position().norm(),
                         .turn_rad = term.pair->motion.heading,
                         .before = value_of(*first->plain, {}),
                         .after = value_of(*term.plain, unknowns),
                         .weight = 1.0 / (1.0 + square / (kLoss * kLoss))});
  }
  return residuals;
}

}  // namespace

double JointCalibration::deviation(CalibrationParameter parameter) const {
  const auto index = static_cast<Eigen::Index>(parameter);
  return std::sqrt(covariance(index, index));
}

JointCalibration calibrated(const OdometryTrack& odometry, std::span<const MotionPair> pairs,
                            const CalibrationStart& start) {
  const std::vector<Term> uncalibrated = terms_of(odometry, pairs, 0.0, start.half_track_m, kLeastNoise);
  Unknowns unknowns;
  double clock_s = 0.0;
  std::vector<Term> terms;
  Eigen::Vector3d spread = spread_of(uncalibrated, unknowns);
  Eigen::Vector3d noise = spread.cwiseMax(kLeastNoise);
  for (int round = 0; round < kRounds; ++round) {
    clock_s = std::clamp(clock_s + unknowns.delay_s, -kMostClockS, kMostClockS);
    unknowns.delay_s = 0.0;
    terms = terms_of(odometry, pairs, clock_s, start.half_track_m, noise);
    solve(terms, start.hold_wheels, unknowns);
    spread = spread_of(terms, unknowns);
    noise = noise_of(terms, spread);
  }
  const Pose2 base_from_recorded{unknowns.laser[0], unknowns.laser[1], unknowns.laser[2]};
  return {.wheels = {unknowns.wheels[0], unknowns.wheels[1], unknowns.wheels[2]},
          .base_from_laser = base_from_recorded * start.base_from_laser,
          .laser_clock_s = clock_s + unknowns.delay_s,
          .covariance = covariance_of(terms, start, unknowns),
          .spread = spread,
          .residuals = residuals_of(uncalibrated, terms, unknowns)};
}

}  // namespace tandem
