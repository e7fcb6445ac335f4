#include "services/localization/core/place_finder.hpp"

#include <cmath>

#include "services/localization/core/beams.hpp"

namespace tandem {
namespace {

constexpr double kSameM = 0.7;
constexpr double kSameRad = 0.3;
constexpr double kWayPerRad = 0.4;  ///< [m/rad] what a turn shows

}  // namespace

PlaceFinder::PlaceFinder(const OccupancyGrid& map, const LikelihoodField& field, const PlaceFinderOptions& options)
    : options_(options), search_(map, field), panorama_(options.panorama) {}

bool PlaceFinder::is_same(const Pose2& a, const Pose2& b) {
  return (a.position() - b.position()).norm() < kSameM && std::abs(turn_between(a.heading, b.heading)) < kSameRad;
}

void PlaceFinder::add(const OdometrySample& odometry, std::span<const Eigen::Vector2d> endpoints_in_base) {
  if (odometry.epoch != last_.epoch) {
    forget();
  } else {
    const Pose2 motion = inverse(last_.odom_from_base) * odometry.odom_from_base;
    way_m_ += motion.position().norm() + kWayPerRad * std::abs(motion.heading);
  }
  last_ = odometry;
  panorama_.add(odometry, endpoints_in_base);
  is_new_ = true;
}

void PlaceFinder::forget() {
  panorama_.clear();
  finding_ = {};
}

const Finding& PlaceFinder::find() {
  if (!is_new_) return finding_;
  is_new_ = false;
  const Pose2 motion = inverse(found_at_) * last_.odom_from_base;
  found_at_ = last_.odom_from_base;
  for (PoseHypothesis& place : finding_.places) place.map_from_base = place.map_from_base * motion;
  if (finding_.places.empty() || way_m_ - searched_at_m_ >= options_.search_every_m) search();
  if (!finding_.places.empty()) {
    finding_.certain = finding_.places.front().weight >= options_.certain_weight &&
                       (way_m_ - leading_since_m_ >= options_.certain_after_m ||
                        last_.time - leading_since_ >= options_.certain_after);
  }
  return finding_;
}

void PlaceFinder::search() {
  searched_at_m_ = way_m_;
  searched_at_ = last_.odom_from_base;
  points_ = thinned(panorama_.endpoints_in_base(options_.cell_m), options_.points);
  const std::vector<PoseHypothesis> before = std::move(finding_.places);
  finding_ = {};
  double sum = 0.0;
  for (const Candidate& candidate : search_.candidates(points_, {})) {
    if (finding_.places.empty()) finding_.score = candidate.score;
    const double weight = std::exp(options_.weight_per_score * (candidate.score - finding_.score));
    finding_.places.push_back({candidate.map_from_base, weight});
    sum += weight;
  }
  for (PoseHypothesis& place : finding_.places) place.weight /= sum;
  const bool leads_on = !before.empty() && !finding_.places.empty() &&
                        is_same(before.front().map_from_base, finding_.places.front().map_from_base);
  if (!leads_on) {
    leading_since_m_ = way_m_;
    leading_since_ = last_.time;
  }
}

double PlaceFinder::score_at(const Pose2& map_from_base) const {
  return search_.score_at(map_from_base * inverse(last_.odom_from_base) * searched_at_, points_);
}

}  // namespace tandem
