#include "services/localization/core/map_scale.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "services/localization/core/beams.hpp"

namespace tandem {
namespace {

using Vector5 = Eigen::Matrix<double, 5, 1>;
using Matrix5 = Eigen::Matrix<double, 5, 5>;

constexpr std::size_t kBeams = 90;
constexpr int kIterations = 5;
constexpr double kLossM = 0.2;             ///< Beams further from a wall than this count less and less.
constexpr double kDeviationM = 0.05;       ///< of a beam
constexpr double kBeamWeight = 0.25;       ///< Neighbouring beams err together: each counts as this much of one.
constexpr double kNearestM = 0.05;         ///< Nearer to the laser a beam has no direction.
constexpr double kMostInformation = 3000;  ///< One scan is never surer: what errs there errs in all its beams.

/// How far the unknowns may be from where they start: x, y [m], heading [rad], log scale, offset [m]. A wall is where
/// its cells are to half of one.
Vector5 prior_deviation(double resolution_m) {
  return {0.3, 0.3, 0.1, 0.1, std::max(0.03, 0.6 * resolution_m)};
}

struct Unknowns {
  Pose2 map_from_base;
  double log_scale = 0.0;
  double offset_m = 0.0;
};

struct Equations {
  Matrix5 information = Matrix5::Zero();
  Vector5 pull = Vector5::Zero();
};

Equations equations_of(const DistanceField& field, std::span<const Eigen::Vector2d> endpoints_in_base,
                       const Unknowns& at, const Eigen::Vector2d& laser_in_base) {
  Equations equations;
  const Pose2 turn{0.0, 0.0, at.map_from_base.heading};
  const double scale = std::exp(at.log_scale);
  for (const Eigen::Vector2d& endpoint : endpoints_in_base) {
    const Eigen::Vector2d beam = endpoint - laser_in_base;
    const double range_m = beam.norm();
    if (range_m < kNearestM) continue;
    const Eigen::Vector2d along = turn * Eigen::Vector2d{beam / range_m};
    const Eigen::Vector2d arm = turn * laser_in_base + (scale * range_m + at.offset_m) * along;
    const Eigen::Vector2d end = at.map_from_base.position() + arm;
    if (!field.contains(end)) continue;
    const auto [distance_m, gradient] = field.smooth(end);
    const double root_weight = 1.0 / (1.0 + distance_m * distance_m / (kLossM * kLossM));
    const double weight = root_weight * root_weight;
    const double by_range = gradient.dot(along);
    Vector5 change;
    change << gradient, gradient.y() * arm.x() - gradient.x() * arm.y(), by_range * scale * range_m, by_range;
    equations.information += weight * change * change.transpose();
    equations.pull += weight * distance_m * change;
  }
  const double sureness = kBeamWeight / (kDeviationM * kDeviationM);
  equations.information *= sureness;
  equations.pull *= sureness;
  return equations;
}

}  // namespace

ScaleMeasurement scale_measurement(const DistanceField& field, std::span<const Eigen::Vector2d> endpoints_in_base,
                                   const Pose2& map_from_base, const Eigen::Vector2d& laser_in_base) {
  const std::vector<Eigen::Vector2d> endpoints = thinned(endpoints_in_base, kBeams);
  const Vector5 prior = prior_deviation(field.resolution_m()).cwiseAbs2().cwiseInverse();
  Unknowns at{.map_from_base = map_from_base};
  Matrix5 information = prior.asDiagonal();
  for (int i = 0; i < kIterations; ++i) {
    const Equations equations = equations_of(field, endpoints, at, laser_in_base);
    information = equations.information;
    information.diagonal() += prior;
    Vector5 pull = equations.pull;  // the pose may go where it wants to
    pull(3) += prior(3) * at.log_scale;
    pull(4) += prior(4) * at.offset_m;
    const Vector5 step = -information.ldlt().solve(pull);
    at.map_from_base = {at.map_from_base.x + step(0), at.map_from_base.y + step(1), at.map_from_base.heading + step(2)};
    at.log_scale += step(3);
    at.offset_m += step(4);
  }
  const double variance = information.ldlt().solve(Vector5::Unit(3))(3);
  return {at.log_scale, std::max(0.0, 1.0 / variance - prior(3))};
}

bool MapScaleWatch::is_due(double way_m) const {
  return entries_.empty() || way_m - entries_.back().way_m >= kSpacingM;
}

void MapScaleWatch::add(const ScaleMeasurement& measurement, double way_m) {
  entries_.push_back({way_m, measurement});
  entries_.back().measurement.information = std::min(measurement.information, kMostInformation);
  while (way_m - entries_.front().way_m > options_.way_m) entries_.pop_front();
  judge();
}

void MapScaleWatch::judge() {
  double sum = 0.0;
  double mean = 0.0;
  for (const Entry& entry : entries_) {
    sum += entry.measurement.information;
    mean += entry.measurement.information * entry.measurement.log_scale;
  }
  if (sum <= 0.0) return;
  mean /= sum;
  double square = 0.0;  // by how scans differ, and not by what each believes of itself
  for (const Entry& entry : entries_) {
    const double share = entry.measurement.information / sum;
    square += share * share * (entry.measurement.log_scale - mean) * (entry.measurement.log_scale - mean);
  }
  if (entries_.back().way_m - entries_.front().way_m < options_.least_m) return;
  const double doubt = 2.0 * std::sqrt(square);
  if (std::abs(mean) + doubt < options_.cleared) {
    wrong_scale_.reset();
  } else if (wrong_scale_ || std::abs(mean) - doubt > options_.named) {
    wrong_scale_ = std::exp(mean);
  }
}

}  // namespace tandem
