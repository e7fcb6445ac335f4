#include <cmath>
#include <utility>

#include "services/localization/core/localizer.hpp"
#include "services/localization/core/scan_search.hpp"

// How the localizer comes to a place, doubts it, and comes to another.

namespace tandem {
namespace {

constexpr double kNewScanShare = 0.2;         ///< Weight of the newest scan in the mean agreement.
constexpr double kHintDeviationRad = 0.3;     ///< How well a person tells a heading.
constexpr double kAnyHeadingRad = 4.0;        ///< Wrapped, as good as uniform.
constexpr double kMirrorCheckM = 1.0;         ///< way after a start
constexpr double kClearlyBetter = 0.1;        ///< gain of agreement
constexpr int kMirroredFits = 3;              ///< scans in a row
constexpr double kNever = -1e9;               ///< [m] on the way
constexpr double kRememberedAgreement = 0.8;  ///< A remembered pose must fit better than one that was followed.

}  // namespace

void Localizer::apply_hint() {
  if (!hint_) return;
  // Between the hint and the last scan the robot has moved on.
  Pose2 map_from_base = hint_->map_from_base;
  const auto then = odometry_.at(hint_->time);
  if (then && last_ && then->epoch == last_->epoch) {
    map_from_base = map_from_base * (inverse(then->odom_from_base) * last_->odom_from_base);
  }
  const double deviation_rad = hint_->heading_known ? kHintDeviationRad : kAnyHeadingRad;
  particles_ = particles_around(map_from_base, hint_->standard_deviation_m, deviation_rad,
                                static_cast<std::size_t>(config_.particles_max), rng_);
  last_fit_.reset();
  window_.restart();
  monitor_.reset();
  trusted_ = true;
  mean_agreement_ = 1.0;
  may_be_carried_ = false;
  probation_from_m_ = kNever;
  started_at_m_ = finder_.way_m();
  hint_.reset();
}

void Localizer::restore(const RememberedPose& pose, Memory memory) {
  remembered_ = pose;
  memory_ = memory;
  memory_outcome_ = MemoryOutcome::Awaited;
}

bool Localizer::starts_where_remembered(const OdometrySample& odometry) {
  const RememberedPose remembered = *std::exchange(remembered_, std::nullopt);
  memory_outcome_ = MemoryOutcome::Refused;
  // The wheels may have turned since, or may have begun to count anew.
  std::vector<Pose2> places{remembered.map_from_base};
  if (remembered.odometry_epoch == odometry.epoch) {
    places.insert(places.begin(),
                  remembered.map_from_base * (inverse(remembered.odom_from_base) * odometry.odom_from_base));
  }
  for (const Pose2& place : places) {
    const PoseFit fit = settled_at(place);
    if (fit.agreement < kRememberedAgreement || !PlaceFinder::is_same(fit.pose.map_from_base, place)) continue;
    believe(fit);
    trusted_ = memory_ == Memory::Fresh;
    memory_outcome_ = MemoryOutcome::Agreed;
    return true;
  }
  return false;
}

void Localizer::start_at(const OdometrySample& odometry) {
  if (remembered_ && starts_where_remembered(odometry)) return;
  if (config_.start.size() != 3) return;
  started_at_m_ = finder_.way_m();
  particles_ = particles_around({config_.start[0], config_.start[1], config_.start[2]}, config_.start_deviation_m,
                                config_.start_deviation_m, static_cast<std::size_t>(config_.particles_max), rng_);
}

void Localizer::remember(const OdometrySample& odometry, bool broken) {
  if (broken) {
    finder_.forget();
    setup_.forget();
  }
  finder_.add(odometry, endpoints_);
  setup_.add(odometry, endpoints_, base_from_laser_, finder_.way_m());
}

bool Localizer::wants_places() {
  const bool is_due = mean_agreement_ < config_.doubt_below && finder_.way_m() - doubted_at_m_ >= config_.doubt_every_m;
  if (trusted_ && !doubting_ && is_due) {
    doubted_at_m_ = finder_.way_m();
    doubting_ = true;
  }
  return !trusted_ || may_be_carried_ || doubting_;
}

void Localizer::search(std::size_t boxes) {
  if (finder_.is_searching()) {
    finder_.advance(boxes);
  } else if (place_score_) {
    setup_.advance(finder_.map(), *place_score_, boxes);
  }
}

void Localizer::compare_with_mirrored() {
  if (!trusted_ || finder_.way_m() - started_at_m_ > kMirrorCheckM) return;
  const Pose2 expected = clusters(particles_, 1).front().map_from_base;
  const double as_it_is = settled_at(expected).agreement;
  const auto exchange = [this](std::vector<Eigen::Vector2d>& endpoints) {
    const Pose2 laser_from_base = inverse(base_from_laser_);
    for (Eigen::Vector2d& endpoint : endpoints) {
      const Eigen::Vector2d in_laser = laser_from_base * endpoint;
      endpoint = base_from_laser_ * Eigen::Vector2d{in_laser.x(), -in_laser.y()};
    }
  };
  const std::vector<Eigen::Vector2d> all = endpoints_;
  const std::vector<Eigen::Vector2d> few = few_endpoints_;
  exchange(endpoints_);
  exchange(few_endpoints_);
  const double mirrored = settled_at(expected).agreement;
  endpoints_ = all;
  few_endpoints_ = few;
  if (mirrored < as_it_is + kClearlyBetter) {
    mirrored_fits_ = 0;
    return;
  }
  probation_from_m_ = finder_.way_m();
  if (++mirrored_fits_ < kMirroredFits) return;
  trusted_ = false;  // the search of the whole map decides
  place_score_ = as_it_is;
}

void Localizer::note_setup() {
  if (const auto fault = setup_.fault()) {
    faults_.add(*fault);
    if (setup_.rules_out_places()) trusted_ = false;
  }
  if (trusted_ && mean_agreement_ >= config_.doubt_below) place_score_.reset();
}

PoseFit Localizer::settled_at(const Pose2& place) const {
  const SearchWindow window{.half_side_m = 0.4, .half_turn_rad = 0.1, .prior_weight = 0.1};
  return fit_at(best_pose_in_window(likelihoods_, few_endpoints_, place, window));
}

void Localizer::believe(const PoseFit& fit) {
  particles_ =
      particles_around(fit.pose.map_from_base, 0.1, 0.05, static_cast<std::size_t>(config_.particles_max), rng_);
  window_.restart();
  monitor_.reset();
  status_ = LocalizationStatus::Ok;
  trusted_ = true;
  mean_agreement_ = 1.0;
  may_be_carried_ = false;
  probation_from_m_ = kNever;
  started_at_m_ = finder_.way_m();
  doubting_ = false;
}

PoseFit Localizer::judged(PoseFit fit, const OdometrySample& odometry) {
  const bool was_ok = status_ == LocalizationStatus::Ok;
  status_ = monitor_.add(odometry.time, fit.agreement);
  mean_agreement_ += kNewScanShare * (fit.agreement - mean_agreement_);
  if (status_ == LocalizationStatus::Lost) trusted_ = false;
  if (broken_off_ && !is_reconciled(fit)) may_be_carried_ = true;
  remember(odometry, broken_off_ || (was_ok && (slipped_ || status_ != LocalizationStatus::Ok)));
  if (slipped_ || status_ != LocalizationStatus::Ok) probation_from_m_ = finder_.way_m();
  if (status_ == LocalizationStatus::Ok && trusted_ && !may_be_carried_) {
    setup_.add_fit(distances_, endpoints_, fit.pose.map_from_base, base_from_laser_.position());
  }
  note_setup();
  if (!wants_places()) return fit;

  finder_.seek();
  search(budget_);
  if (!finder_.is_searching()) doubting_ = false;
  const Finding& finding = finder_.finding();
  if (finding.places.empty()) return fit;
  const Pose2& place = finding.places.front().map_from_base;
  place_score_ = finding.score;
  const bool is_elsewhere = !PlaceFinder::is_same(place, fit.pose.map_from_base);
  if (trusted_ && !may_be_carried_) {
    const double gain = finding.score - finder_.score_at(fit.pose.map_from_base);
    if (is_elsewhere && gain > config_.doubt_score) trusted_ = false;
  } else if (finding.certain && !setup_.rules_out_places()) {
    if (trusted_ && !is_elsewhere) {  // not carried after all
      may_be_carried_ = false;
      return fit;
    }
    const PoseFit there = is_elsewhere ? settled_at(place) : fit;
    if (there.agreement < config_.agreement_ok) return fit;
    believe(there);
    return there;
  }
  return fit;
}

std::optional<LocalizationResult> Localizer::sought(const OdometrySample& odometry) {
  last_ = odometry;
  remember(odometry, false);
  finder_.seek();
  search(budget_);
  note_setup();
  const Finding& finding = finder_.finding();
  if (finding.places.empty()) return std::nullopt;
  place_score_ = finding.score;
  const PoseFit fit = settled_at(finding.places.front().map_from_base);
  status_ = LocalizationStatus::Uncertain;
  if (finding.certain && !setup_.rules_out_places() && fit.agreement >= config_.agreement_ok) believe(fit);
  return claim(odometry, fit, {finding.places.begin() + 1, finding.places.end()});
}

}  // namespace tandem
