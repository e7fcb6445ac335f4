#include "services/map_builder/core/scan_registration.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace tandem {
namespace {

constexpr double kSameWay = 0.7;       ///< Cosine between two normals that belong to one surface.
constexpr double kStillM = 1e-4;       ///< A step this small ...
constexpr double kStillRad = 2e-5;     ///< ... is the last.
constexpr double kTrustedShare = 0.7;  ///< The reach shrinks to this share at each step.

/// The normal equations of all pairs, about a small motion of the scan in its own frame.
struct Equations {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
  double weights = 0.0;
  double squares = 0.0;
};

Equations paired(const SurfaceIndex& reference, const Surface& scan, const Pose2& reference_from_scan, double reach_m,
                 double loss_m) {
  Equations sum;
  const double c = std::cos(reference_from_scan.heading);
  const double s = std::sin(reference_from_scan.heading);
  Eigen::Matrix2d turn;
  turn << c, -s, s, c;
  const Eigen::Vector2d origin = reference_from_scan.position();
  for (const SurfacePoint& p : scan) {
    const Eigen::Vector2d there = turn * p.point + origin;
    const SurfacePoint* const met = reference.nearest(there, reach_m);
    if (met == nullptr) continue;
    const Eigen::Vector2d own = turn * p.normal;
    const bool has_normal = !met->normal.isZero();
    if (has_normal && !p.normal.isZero() && own.dot(met->normal) < kSameWay) continue;
    const Eigen::Vector2d across = has_normal ? met->normal : own;
    if (across.isZero()) continue;
    const double distance_m = across.dot(there - met->point);
    const double weight = 1.0 / (1.0 + distance_m * distance_m / (loss_m * loss_m));
    // A motion (x, y, a) of the scan in its own frame moves the point by turn * ((x, y) + a * (-p.y, p.x)).
    const Eigen::Vector2d n = turn.transpose() * across;
    const Eigen::Vector3d row{n.x(), n.y(), n.y() * p.point.x() - n.x() * p.point.y()};
    sum.information += weight * row * row.transpose();
    sum.pull -= weight * distance_m * row;
    sum.weights += weight;
    sum.squares += weight * distance_m * distance_m;
  }
  return sum;
}

}  // namespace

Registration registered(const SurfaceIndex& reference, const Surface& scan, const Pose2& guess,
                        const RegistrationOptions& options) {
  Registration result{.reference_from_scan = guess};
  const double per_pair = options.point_weight / (options.deviation_m * options.deviation_m);
  double reach_m = options.first_reach_m;
  for (int step = 0; step < options.most_steps; ++step) {
    const Equations sum = paired(reference, scan, result.reference_from_scan, reach_m, options.loss_m);
    // Away from the guess the prior pulls back; both are taken in the scan's frame, as the motions are small.
    const Pose2 away = inverse(guess) * result.reference_from_scan;
    const Eigen::Matrix3d all = per_pair * sum.information + options.prior + 1e-6 * Eigen::Matrix3d::Identity();
    const Eigen::Vector3d pull = per_pair * sum.pull - options.prior * Eigen::Vector3d{away.x, away.y, away.heading};
    const Eigen::Vector3d move = all.ldlt().solve(pull);
    if (!move.allFinite()) break;
    result.reference_from_scan = result.reference_from_scan * Pose2{move.x(), move.y(), move.z()};
    const bool narrow = reach_m <= options.last_reach_m;
    reach_m = std::max(options.last_reach_m, kTrustedShare * reach_m);
    if (narrow && move.head<2>().norm() < kStillM && std::abs(move.z()) < kStillRad) break;
  }
  const Equations sum = paired(reference, scan, result.reference_from_scan, options.last_reach_m, options.loss_m);
  result.information = per_pair * sum.information;
  result.matched_share = matched_share(reference, scan, result.reference_from_scan, options.last_reach_m);
  if (sum.weights > 0.0) result.spread_m = std::sqrt(sum.squares / sum.weights);
  return result;
}

double matched_share(const SurfaceIndex& reference, const Surface& scan, const Pose2& reference_from_scan,
                     double reach_m) {
  if (scan.empty()) return 0.0;
  std::size_t matched = 0;
  for (const SurfacePoint& p : scan) {
    if (reference.nearest(reference_from_scan * p.point, reach_m) != nullptr) ++matched;
  }
  return static_cast<double>(matched) / static_cast<double>(scan.size());
}

}  // namespace tandem
