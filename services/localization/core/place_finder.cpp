#include "services/localization/core/place_finder.hpp"

#include <cmath>
#include <utility>

#include "services/localization/core/beams.hpp"

namespace tandem {
namespace {

constexpr double kSameM = 0.7;
constexpr double kSameRad = 0.3;
constexpr double kWayPerRad = 0.4;      ///< [m/rad] what a turn shows
constexpr double kSearchedShare = 0.5;  ///< of the way over which a place must lead, there must be searches

}  // namespace

PlaceFinder::PlaceFinder(const OccupancyGrid& map, const LikelihoodField& field, const PlaceFinderOptions& options)
    : options_(options), map_(map, field), panorama_(options.panorama) {}

bool PlaceFinder::is_same(const Pose2& a, const Pose2& b) {
  return (a.position() - b.position()).norm() < kSameM && std::abs(turn_between(a.heading, b.heading)) < kSameRad;
}

void PlaceFinder::add(const OdometrySample& odometry, std::span<const Eigen::Vector2d> endpoints_in_base) {
  if (!asked_) {
    finding_ = {};
    search_.reset();
  }
  asked_ = false;
  if (odometry.epoch != last_.epoch) {
    forget();
  } else {
    const Pose2 motion = inverse(last_.odom_from_base) * odometry.odom_from_base;
    way_m_ += motion.position().norm() + kWayPerRad * std::abs(motion.heading);
    for (PoseHypothesis& place : finding_.places) place.map_from_base = place.map_from_base * motion;
  }
  last_ = odometry;
  panorama_.add(odometry, endpoints_in_base);
  judge();
}

void PlaceFinder::forget() {
  panorama_.clear();
  finding_ = {};
  search_.reset();
}

void PlaceFinder::seek() {
  asked_ = true;
  const bool is_recent = !finding_.places.empty() && way_m_ - answered_.way_m < options_.search_every_m;
  if (search_ || is_recent) return;
  Question question{thinned(panorama_.endpoints_in_base(options_.cell_m), options_.points), last_, way_m_};
  GlobalSearchRun run{map_, question.points_in_base, {}};
  search_.emplace(Search{std::move(question), std::move(run)});
}

void PlaceFinder::advance(std::size_t boxes) {
  if (!search_) return;
  search_->run.advance(map_, boxes);
  if (!search_->run.is_done()) return;
  adopt(*search_);
  search_.reset();
}

void PlaceFinder::adopt(const Search& search) {
  const std::vector<PoseHypothesis> before = std::move(finding_.places);
  answered_ = search.question;
  finding_ = {};
  const Pose2 motion = inverse(answered_.at.odom_from_base) * last_.odom_from_base;
  double sum = 0.0;
  for (const Candidate& candidate : search.run.candidates()) {
    if (finding_.places.empty()) finding_.score = candidate.score;
    const double weight = std::exp(options_.weight_per_score * (candidate.score - finding_.score));
    finding_.places.push_back({candidate.map_from_base * motion, weight});
    sum += weight;
  }
  for (PoseHypothesis& place : finding_.places) place.weight /= sum;
  const bool leads_on = !before.empty() && !finding_.places.empty() &&
                        is_same(before.front().map_from_base, finding_.places.front().map_from_base);
  if (!leads_on) {
    leading_since_m_ = answered_.way_m;
    leading_since_ = answered_.at.time;
  }
  judge();
}

void PlaceFinder::judge() {
  if (finding_.places.empty()) return;
  // One search alone says nothing of the way after it.
  const bool over_way = way_m_ - leading_since_m_ >= options_.certain_after_m &&
                        answered_.way_m - leading_since_m_ >= kSearchedShare * options_.certain_after_m;
  const bool over_time = last_.time - leading_since_ >= options_.certain_after;
  finding_.certain = finding_.places.front().weight >= options_.certain_weight && (over_way || over_time);
}

double PlaceFinder::score_at(const Pose2& map_from_base) const {
  const Pose2 motion = inverse(answered_.at.odom_from_base) * last_.odom_from_base;
  return map_.score_at(map_from_base * inverse(motion), answered_.points_in_base);
}

}  // namespace tandem
