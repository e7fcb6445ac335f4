#include "services/localization/core/setup_check.hpp"

#include <algorithm>
#include <cmath>

#include "services/localization/core/beams.hpp"

namespace tandem {
namespace {

constexpr double kScaleStep = 1.05;          ///< A scale that lies between two of the list still fits near the robot.
constexpr int kScaleSteps = 15;              ///< each way: from 1/2.08 to 2.08
constexpr std::size_t kMostNodes = 100'000;  ///< An alternative that is right is found much sooner.

}  // namespace

SetupCheck::SetupCheck(const SetupCheckOptions& options)
    : options_(options), seen_(options.panorama), mirrored_(options.panorama), scale_(options.scale) {
  alternatives_.push_back({.mirrored = true});
  // A smaller change of scale leaves the robot where it is, and is measured there.
  for (int i = 2; i <= kScaleSteps; ++i) {
    alternatives_.push_back({.scale = std::pow(kScaleStep, i)});
    alternatives_.push_back({.scale = std::pow(kScaleStep, -i)});
  }
}

void SetupCheck::add(const OdometrySample& odometry, std::span<const Eigen::Vector2d> endpoints_in_base,
                     const Pose2& base_from_laser, double way_m) {
  way_m_ = way_m;
  const Pose2 laser_from_base = inverse(base_from_laser);
  std::vector<Eigen::Vector2d> exchanged;
  exchanged.reserve(endpoints_in_base.size());
  for (const Eigen::Vector2d& endpoint : endpoints_in_base) {
    const Eigen::Vector2d in_laser = laser_from_base * endpoint;
    exchanged.push_back(base_from_laser * Eigen::Vector2d{in_laser.x(), -in_laser.y()});
  }
  seen_.add(odometry, endpoints_in_base);
  mirrored_.add(odometry, exchanged);
}

void SetupCheck::add_fit(const DistanceField& field, std::span<const Eigen::Vector2d> endpoints_in_base,
                         const Pose2& map_from_base, const Eigen::Vector2d& laser_in_base) {
  if (!scale_.is_due(way_m_)) return;
  scale_.add(scale_measurement(field, endpoints_in_base, map_from_base, laser_in_base), way_m_);
}

void SetupCheck::forget() {
  seen_.clear();
  mirrored_.clear();
  run_.reset();
}

void SetupCheck::advance(const GlobalSearch& map, double score, std::size_t boxes) {
  if (!run_) begin(map, score);
  if (!run_) return;
  run_->advance(map, boxes);
  if (!run_->is_done()) return;
  const Verdict found = verdict();
  run_.reset();
  conclude(found);
}

std::vector<Eigen::Vector2d> SetupCheck::points_of(const Alternative& alternative) const {
  const Panorama& panorama = alternative.mirrored ? mirrored_ : seen_;
  std::vector<Eigen::Vector2d> points = thinned(panorama.endpoints_in_base(options_.cell_m), options_.points);
  for (Eigen::Vector2d& point : points) point *= alternative.scale;
  return points;
}

void SetupCheck::begin(const GlobalSearch& map, double score) {
  // Asked again where the robot has hardly moved, all would be answered as before.
  double& last_asked_m = votes_ > 0 ? begun_at_m_ : all_begun_at_m_;
  if ((votes_ > 0 || current_ == 0) && way_m_ - last_asked_m < options_.apart_m) return;
  if (current_ == 0) all_begun_at_m_ = way_m_;
  GlobalSearchOptions search;
  search.count = 1;
  search.floor = std::max(score + options_.clearly_better, options_.least_score);
  const bool may_be_withdrawn = is_named_ && score >= options_.least_score;
  if (may_be_withdrawn) search.floor = score;
  asked_score_ = score;
  search.max_nodes = kMostNodes;
  begun_at_m_ = way_m_;
  run_.emplace(map, points_of(alternatives_[current_]), search);
}

SetupCheck::Verdict SetupCheck::verdict() const {
  const double wanted = std::max(asked_score_ + options_.clearly_better, options_.least_score);
  if (!run_->candidates().empty())
    return run_->candidates().front().score >= wanted ? Verdict::Better : Verdict::Neither;
  const bool is_worse = is_named_ && asked_score_ >= options_.least_score && !run_->gave_up();
  return is_worse ? Verdict::Worse : Verdict::Neither;
}

void SetupCheck::conclude(Verdict verdict) {
  const bool counts_against = verdict == Verdict::Worse || (verdict == Verdict::Neither && !is_named_);
  if (verdict == Verdict::Better) votes_ = std::min(votes_ + 1, options_.votes);
  if (counts_against) votes_ = std::max(votes_ - 1, 0);
  if (votes_ == options_.votes) is_named_ = true;
  if (votes_ > 0) return;
  is_named_ = false;
  current_ = (current_ + 1) % alternatives_.size();
}

std::optional<InputFault> SetupCheck::fault() const {
  if (is_named_) return alternatives_[current_].mirrored ? InputFault::LaserMirrored : InputFault::MapScaleWrong;
  if (scale_.wrong_scale()) return InputFault::MapScaleWrong;
  return std::nullopt;
}

}  // namespace tandem
