#include "calibration/core/camera_calibration.hpp"

#include <ceres/autodiff_cost_function.h>
#include <ceres/covariance.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "calibration/core/board_pose.hpp"
#include "services/common/format.hpp"

namespace tandem {
namespace {

constexpr double kFirstPixel = 0.5;   ///< Spread of the corners [px] before it is measured.
constexpr double kLeastPixel = 0.02;  ///< A perfect board would divide by nothing.
constexpr int kRounds = 3;

struct Unknowns {
  std::array<double, 4> lens{};
  std::array<double, 6> mount{};
  std::vector<std::array<double, 6>> boards;  ///< x, y, heading on the ground; or angle-axis and place in the camera
};

Eigen::Vector2d middle_of(const CameraModel& model) {
  return {(model.width_px - 1) / 2.0, (model.height_px - 1) / 2.0};
}

Unknowns unknowns_of(std::span<const BoardView> views, const CameraModel& guess) {
  Unknowns unknowns{
      .lens = {guess.focal_px, guess.principal_offset_px.x(), guess.principal_offset_px.y(), guess.radial},
      .mount = {guess.position_in_base.x(), guess.position_in_base.y(), guess.position_in_base.z(), guess.pitch_rad,
                guess.yaw_rad, guess.roll_rad},
      .boards = {}};
  for (const BoardView& view : views) {
    if (const auto& laid = view.base_from_board) {
      unknowns.boards.push_back({laid->x, laid->y, laid->heading});
    } else {
      unknowns.boards.push_back(camera_from_board(view.corners, middle_of(guess), guess.focal_px));
    }
  }
  return unknowns;
}

CameraModel model_of(const Unknowns& unknowns, CameraModel model) {
  model.focal_px = unknowns.lens[0];
  model.principal_offset_px = {unknowns.lens[1], unknowns.lens[2]};
  model.radial = unknowns.lens[3];
  model.position_in_base = {unknowns.mount[0], unknowns.mount[1], unknowns.mount[2]};
  model.pitch_rad = unknowns.mount[3];
  model.yaw_rad = unknowns.mount[4];
  model.roll_rad = unknowns.mount[5];
  return model;
}

void add_held(const BoardView& view, const Picture& picture, double* board, Unknowns& unknowns,
              ceres::Problem& problem) {
  for (const SeenCorner& corner : view.corners) {
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<HeldCornerResidual, 2, 4, 6>(new HeldCornerResidual(corner, picture)), nullptr,
        unknowns.lens.data(), board);
  }
}

void add_laid(const BoardView& view, const Picture& picture, const PlacementDeviation& placement, double* board,
              Unknowns& unknowns, ceres::Problem& problem) {
  for (const SeenCorner& corner : view.corners) {
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<CornerResidual, 2, 4, 6, 3>(new CornerResidual(corner, picture)), nullptr,
        unknowns.lens.data(), unknowns.mount.data(), board);
  }
  const Pose2& laid = *view.base_from_board;
  const Eigen::Vector3d deviation{placement.position_m, placement.position_m, placement.heading_rad};
  problem.AddResidualBlock(new ceres::AutoDiffCostFunction<PlacementResidual, 3, 3>(
                               new PlacementResidual({laid.x, laid.y, laid.heading}, deviation)),
                           nullptr, board);
}

void build(std::span<const BoardView> views, const Picture& picture, const PlacementDeviation& placement,
           Unknowns& unknowns, ceres::Problem& problem) {
  for (std::size_t i = 0; i < views.size(); ++i) {
    double* const board = unknowns.boards[i].data();
    if (views[i].base_from_board) {
      add_laid(views[i], picture, placement, board, unknowns, problem);
    } else {
      add_held(views[i], picture, board, unknowns, problem);
    }
  }
}

std::vector<Eigen::Vector2d> residuals_of(std::span<const BoardView> views, const Eigen::Vector2d& middle_px,
                                          const Unknowns& unknowns) {
  std::vector<Eigen::Vector2d> residuals;
  for (std::size_t i = 0; i < views.size(); ++i) {
    for (const SeenCorner& corner : views[i].corners) {
      Eigen::Vector2d off;
      const Picture picture{middle_px, 1.0};
      const double* const board = unknowns.boards[i].data();
      if (views[i].base_from_board) {
        CornerResidual{corner, picture}(unknowns.lens.data(), unknowns.mount.data(), board, off.data());
      } else {
        HeldCornerResidual{corner, picture}(unknowns.lens.data(), board, off.data());
      }
      residuals.push_back(off);
    }
  }
  return residuals;
}

/// Of numbers that were fitted: what was fitted is no longer spread.
double spread_of(std::span<const BoardView> views, const std::vector<Eigen::Vector2d>& residuals) {
  double squares = 0.0;
  double free = 2.0 * static_cast<double>(residuals.size()) - kCameraParameters;
  for (const Eigen::Vector2d& residual : residuals) squares += residual.squaredNorm();
  for (const BoardView& view : views) free -= view.base_from_board ? 3.0 : 6.0;
  return std::max(kLeastPixel, std::sqrt(squares / std::max(1.0, free)));
}

CameraCovariance covariance_of(ceres::Problem& problem, const Unknowns& unknowns) {
  ceres::Covariance::Options options;
  options.algorithm_type = ceres::DENSE_SVD;
  options.min_reciprocal_condition_number = 1e-18;  // pixels beside radians: far apart in size, not unknown
  ceres::Covariance covariance{options};
  const double* const lens = unknowns.lens.data();
  const double* const mount = unknowns.mount.data();
  CameraCovariance result = CameraCovariance::Constant(std::numeric_limits<double>::quiet_NaN());
  if (!covariance.Compute(std::vector<const double*>{lens, mount}, &problem)) return result;
  Eigen::Matrix<double, kCameraParameters, kCameraParameters, Eigen::RowMajor> all;
  covariance.GetCovarianceMatrix({lens, mount}, all.data());
  return all;
}

}  // namespace

CameraCalibration calibrated_camera(std::span<const BoardView> views, const CameraModel& guess,
                                    const PlacementDeviation& placement) {
  const Eigen::Vector2d middle_px = middle_of(guess);
  Unknowns unknowns = unknowns_of(views, guess);
  CameraCalibration result;
  result.pixel_px = kFirstPixel;
  for (int round = 0; round < kRounds; ++round) {
    ceres::Problem problem;
    build(views, {middle_px, result.pixel_px}, placement, unknowns, problem);
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_SCHUR;
    options.max_num_iterations = 200;
    options.num_threads = 1;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    result.residuals_px = residuals_of(views, middle_px, unknowns);
    result.pixel_px = spread_of(views, result.residuals_px);
    if (round + 1 == kRounds) result.covariance = covariance_of(problem, unknowns);
  }
  result.model = model_of(unknowns, guess);
  return result;
}

std::vector<std::string> missing_views(std::span<const BoardView> views, const CameraCalibration* calibration) {
  constexpr std::size_t kLeastLaid = 3;
  constexpr std::size_t kLeastHeld = 8;
  std::vector<std::string> missing;
  std::size_t laid = 0;
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = 0.0;
  for (const BoardView& view : views) {
    if (!view.base_from_board) continue;
    ++laid;
    nearest = std::min(nearest, view.base_from_board->position().norm());
    farthest = std::max(farthest, view.base_from_board->position().norm());
  }
  if (laid < kLeastLaid) {
    missing.push_back(
        formatted("lay the board on the ground at %zu places at least: it was found at %zu", kLeastLaid, laid));
  } else if (farthest < 1.3 * nearest) {
    missing.push_back("lay the board both near and far: the farthest place a third as far again as the nearest");
  }
  if (views.size() - laid < kLeastHeld) {
    missing.push_back(
        formatted("hold the board before the camera, tilted, in %zu pictures at least: it was found in %zu", kLeastHeld,
                  views.size() - laid));
  }
  if (!missing.empty() || calibration == nullptr) return missing;
  const auto known = [&](int row, double limit) { return std::sqrt(calibration->covariance(row, row)) < limit; };
  if (!known(1, 5.0) || !known(2, 5.0) || !known(0, 0.02 * calibration->model.focal_px)) {
    missing.push_back("hold the board nearer and tilt it more, to all sides and in all corners of the picture");
  }
  if (!known(4, 0.02) || !known(5, 0.02) || !known(6, 0.02) || !known(7, 0.01) || !known(8, 0.01)) {
    missing.push_back("lay the board at more places on the ground, near and far, to the left and to the right");
  }
  return missing;
}

}  // namespace tandem
