#include "services/localization/core/localizer.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "services/localization/core/beams.hpp"
#include "services/localization/core/scan_agreement.hpp"
#include "services/localization/core/scan_search.hpp"

namespace tandem {
namespace {

constexpr double kFieldReachM = 2.0;       ///< Distances beyond this say nothing about where a wall is.
constexpr std::size_t kMinReturns = 20;    ///< Fewer beams do not tell one place from another.
constexpr double kClearlyBetter = 0.05;    ///< Gain of agreement for which a searched pose is taken.
constexpr double kSearchedShare = 0.5;     ///< Share of the particles put at a searched pose.
constexpr double kSlipM = 0.3;             ///< A correction this large is motion that the wheels missed.
constexpr double kNewScanShare = 0.2;      ///< Weight of the newest scan in the mean agreement.
constexpr double kHintDeviationRad = 0.3;  ///< How well a person tells a heading.
constexpr double kAnyHeadingRad = 4.0;     ///< Wrapped, as good as uniform.
constexpr double kStuckM = 0.3;            ///< A laser cannot see the very same over this way.
constexpr double kFastestMps = 5.0;        ///< No robot of ours drives faster, ...
constexpr double kFastestRadps = 8.0;      ///< ... or turns faster.
constexpr double kShortestS = 0.1;         ///< Stamps of samples close together are not exact.
constexpr double kNever = -1e9;            ///< [m] on the way

PlaceFinderOptions finder_options(const LocalizationConfig& config) {
  PlaceFinderOptions options;
  options.panorama.way_m = config.panorama_way_m;
  options.weight_per_score = config.place_weight_per_score;
  options.certain_weight = config.place_certain_weight;
  options.certain_after_m = config.place_certain_m;
  return options;
}

WindowOptions window_options(const LocalizationConfig& config, double resolution_m) {
  return {.scans = static_cast<std::size_t>(config.window_scans),
          .older_beams = static_cast<std::size_t>(config.filter_beams),
          .loss_m = config.refine_loss_m,
          .beam_weight = config.refine_beam_weight,
          .map_deviation_m = config.map_deviation_cells * resolution_m,
          .prior_deviation_m = config.prior_deviation_m,
          .prior_deviation_rad = config.prior_deviation_rad};
}

MotionNoise noise_of(const LocalizationConfig& config) {
  return {config.forward_per_m, config.sideways_per_m, config.turn_per_rad,
          config.turn_per_m,    config.drift_m,        config.drift_rad};
}

/// Puts `share` of the particles at the end of the set around `pose`; the weights stay normalised.
void gather(Particles& particles, double share, const Pose2& pose, double deviation_m, double deviation_rad, Rng& rng) {
  const auto count = static_cast<std::size_t>(share * static_cast<double>(particles.size()));
  if (count == 0) return;
  const Particles gathered = particles_around(pose, deviation_m, deviation_rad, count, rng);
  const std::size_t first = particles.size() - count;
  for (std::size_t i = 0; i < count; ++i) particles[first + i].map_from_base = gathered[i].map_from_base;
}

}  // namespace

Localizer::Localizer(OccupancyGrid map, const LocalizationConfig& config)
    : config_(config),
      map_(std::move(map)),
      distances_(map_, kFieldReachM),
      likelihoods_(map_, distances_, BeamModel{config.hit_deviation_m, config.random_share}),
      finder_(map_, likelihoods_, finder_options(config)),
      window_(distances_, window_options(config, map_.resolution_m())),
      rng_(static_cast<std::uint64_t>(config.seed)),
      odometry_(from_seconds(config.odometry_max_age_s)),
      monitor_(config.agreement_ok, from_seconds(config.lost_after_s)) {}

void Localizer::add_odometry(const OdometrySample& sample) {
  odometry_.add(sample);
}

void Localizer::add_hint(const PoseHint& hint) {
  hint_ = hint;
}

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
  probation_from_m_ = kNever;
  hint_.reset();
}

void Localizer::start_at(const OdometrySample& odometry) {
  if (!particles_.empty()) return;
  last_ = odometry;
  if (config_.start.size() == 3) {
    particles_ = particles_around({config_.start[0], config_.start[1], config_.start[2]}, config_.start_deviation_m,
                                  config_.start_deviation_m, static_cast<std::size_t>(config_.particles_max), rng_);
  }
}

std::pair<Pose2, MotionDeviation> Localizer::predict(const OdometrySample& odometry) {
  Pose2 motion;  // across a break of the odometry: none that is known
  bool known = last_->epoch == odometry.epoch;
  if (known) {
    motion = inverse(last_->odom_from_base) * odometry.odom_from_base;
    const double seconds = std::max(kShortestS, to_seconds(odometry.time - last_->time));
    if (motion.position().norm() > kFastestMps * seconds || std::abs(motion.heading) > kFastestRadps * seconds) {
      faults_.add(InputFault::OdometryJump);
      motion = {};
      known = false;
    }
  }
  if (!known) {
    window_.restart();
    finder_.forget();
  }
  const double factor = odometry.time < distrust_until_ ? config_.distrust_factor : 1.0;
  const MotionDeviation deviation = deviation_of(motion, noise_of(config_).times(factor));
  move(particles_, motion, deviation, rng_);
  last_ = odometry;
  return {motion, deviation};
}

PoseFit Localizer::tracked(const Cluster& group, const Pose2& motion, const MotionDeviation& deviation) {
  RefinedPose pose{group.map_from_base, group.covariance};
  if (config_.window_scans > 0) pose = window_.add(group.map_from_base, endpoints_, motion, deviation);
  return {pose, agreement_at(pose.map_from_base)};
}

PoseFit Localizer::fit_at(const Pose2& map_from_base) const {
  const RefinementOptions options{.loss_m = config_.refine_loss_m,
                                  .hit_deviation_m = config_.hit_deviation_m,
                                  .beam_weight = config_.beam_weight,
                                  .prior_deviation_m = config_.prior_deviation_m,
                                  .prior_deviation_rad = config_.prior_deviation_rad};
  const RefinedPose refined = refine_pose(distances_, endpoints_, map_from_base, options);
  return {refined, agreement_at(refined.map_from_base)};
}

double Localizer::agreement_at(const Pose2& map_from_base) const {
  return agreement_of(map_, distances_, map_from_base, laser_in_base_, endpoints_, config_.fit_distance_m);
}

PoseFit Localizer::corrected(PoseFit fit, Time time) {
  slipped_ = false;
  if (fit.agreement >= config_.search_below || !trusted_) return fit;  // lost: the finder looks everywhere
  const SearchWindow window{.half_side_m = config_.search_window_m,
                            .half_turn_rad = config_.search_window_rad,
                            .prior_weight = config_.search_prior_weight};
  const Pose2 found = best_pose_in_window(likelihoods_, few_endpoints_, fit.pose.map_from_base, window);
  const PoseFit searched = fit_at(found);
  if (searched.agreement < fit.agreement + kClearlyBetter) return fit;
  slipped_ = (searched.pose.map_from_base.position() - fit.pose.map_from_base.position()).norm() > kSlipM;
  window_.restart();
  gather(particles_, kSearchedShare, searched.pose.map_from_base, 0.1, 0.05, rng_);
  normalise(particles_);
  distrust_until_ = time + from_seconds(config_.distrust_s);
  return searched;
}

void Localizer::remember(const OdometrySample& odometry, bool broken) {
  if (broken) finder_.forget();
  finder_.add(odometry, endpoints_);
}

bool Localizer::is_in_doubt() {
  if (!trusted_) return true;
  if (mean_agreement_ >= config_.doubt_below || finder_.way_m() - doubted_at_m_ < config_.doubt_every_m) return false;
  doubted_at_m_ = finder_.way_m();
  return true;
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
  probation_from_m_ = kNever;
}

PoseFit Localizer::judged(PoseFit fit, const OdometrySample& odometry) {
  const bool was_ok = status_ == LocalizationStatus::Ok;
  status_ = monitor_.add(odometry.time, fit.agreement);
  mean_agreement_ += kNewScanShare * (fit.agreement - mean_agreement_);
  if (status_ == LocalizationStatus::Lost) trusted_ = false;
  remember(odometry, was_ok && (slipped_ || status_ != LocalizationStatus::Ok));
  if (slipped_ || status_ != LocalizationStatus::Ok) probation_from_m_ = finder_.way_m();
  if (!is_in_doubt()) return fit;

  const Finding& finding = finder_.find();
  if (finding.places.empty()) return fit;
  const Pose2& place = finding.places.front().map_from_base;
  const bool is_elsewhere = !PlaceFinder::is_same(place, fit.pose.map_from_base);
  if (trusted_) {
    const double gain = finding.score - finder_.score_at(fit.pose.map_from_base);
    if (is_elsewhere && gain > config_.doubt_score) trusted_ = false;
  } else if (finding.certain) {
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
  const Finding& finding = finder_.find();
  if (finding.places.empty()) return std::nullopt;
  const PoseFit fit = settled_at(finding.places.front().map_from_base);
  status_ = LocalizationStatus::Uncertain;
  if (finding.certain && fit.agreement >= config_.agreement_ok) believe(fit);
  return claimed(odometry, fit, {finding.places.begin() + 1, finding.places.end()});
}

void Localizer::resample(const PoseFit& fit) {
  if (effective_share(particles_) < config_.resample_below) {
    const auto wanted = static_cast<std::int64_t>(kld_count(particles_, config_.kld_error, config_.kld_quantile));
    const std::int64_t most = std::max(config_.particles_max, static_cast<std::int64_t>(particles_.size()));
    const std::int64_t count = std::clamp(wanted, config_.particles_min, most);
    particles_ = resampled(particles_, static_cast<std::size_t>(count), rng_);
    if (fit.agreement >= config_.agreement_ok) {
      gather(particles_, config_.refined_share, fit.pose.map_from_base, 0.03, 0.015, rng_);
    }
  }
}

std::nullopt_t Localizer::refused(InputFault fault) {
  faults_.add(fault);
  return std::nullopt;
}

bool Localizer::is_stuck(const LaserScan& scan, const OdometrySample& odometry) {
  // Bytes, not numbers: NaN is not equal to itself.
  const auto bytes = [](const std::vector<float>& ranges) { return std::as_bytes(std::span{ranges}); };
  const auto now = bytes(scan.ranges_m);
  const auto before = bytes(seen_ranges_m_);
  if (!std::equal(now.begin(), now.end(), before.begin(), before.end())) {
    seen_ranges_m_ = scan.ranges_m;
    seen_at_ = odometry.odom_from_base;
    return false;
  }
  return (odometry.odom_from_base.position() - seen_at_.position()).norm() > kStuckM;
}

std::optional<LocalizationResult> Localizer::add_scan(const LaserScan& scan) {
  const bool thinned_out = config_.scans == "odd" && scan_count_ % 2 == 0;
  ++scan_count_;
  if (thinned_out) return std::nullopt;  // as if it had never been there
  const auto odometry = odometry_.at(scan.time);
  if (!odometry) return refused(InputFault::ScanWithoutOdometry);
  if (last_ && scan.time < last_->time) return refused(InputFault::ScanOutOfOrder);
  start_at(*odometry);
  apply_hint();
  if (!is_started()) return std::nullopt;
  laser_in_base_ = scan.base_from_laser.position();
  endpoints_ = selected_endpoints(scan, static_cast<std::size_t>(config_.refine_beams), config_.range_limit_m,
                                  odometry->velocity);
  if (endpoints_.size() < kMinReturns) return refused(InputFault::ScanWithTooFewReturns);
  if (is_stuck(scan, *odometry)) return refused(InputFault::ScanStuck);
  few_endpoints_ = thinned(endpoints_, static_cast<std::size_t>(config_.filter_beams));

  if (particles_.empty()) return sought(*odometry);
  if (const auto resting = fit_at_rest(*odometry)) return claimed(*odometry, *resting, {});

  const auto [motion, deviation] = predict(*odometry);
  weigh(particles_, likelihoods_, few_endpoints_, config_.beam_weight);
  const auto groups = clusters(particles_, 3);
  const PoseFit fit = judged(corrected(tracked(groups.front(), motion, deviation), scan.time), *odometry);
  resample(fit);
  last_fit_ = fit;
  const auto others = trusted_ ? other_groups(groups) : other_places(finder_.last_finding(), fit.pose.map_from_base);
  return claimed(*odometry, fit, others);
}

std::optional<PoseFit> Localizer::fit_at_rest(const OdometrySample& odometry) const {
  if (!last_fit_ || status_ != LocalizationStatus::Ok || !trusted_ || last_->epoch != odometry.epoch) {
    return std::nullopt;
  }
  const Pose2 motion = inverse(last_->odom_from_base) * odometry.odom_from_base;
  if (motion.position().norm() >= config_.min_motion_m || std::abs(motion.heading) >= config_.min_turn_rad) {
    return std::nullopt;
  }
  PoseFit fit = *last_fit_;
  fit.pose.map_from_base = fit.pose.map_from_base * motion;
  fit.agreement = agreement_at(fit.pose.map_from_base);
  if (fit.agreement < config_.agreement_ok) return std::nullopt;
  return fit;
}

LocalizationResult Localizer::claimed(const OdometrySample& odometry, const PoseFit& fit,
                                      const std::vector<PoseHypothesis>& others) const {
  const bool on_probation = finder_.way_m() - probation_from_m_ < config_.place_certain_m;
  const bool doubtful = !trusted_ || on_probation;
  const bool claims_too_much = doubtful && status_ == LocalizationStatus::Ok;
  return result_of(odometry, fit, claims_too_much ? LocalizationStatus::Uncertain : status_, others);
}

}  // namespace tandem
