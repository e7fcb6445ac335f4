#include "services/localization/core/localizer.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "services/localization/core/beams.hpp"
#include "services/localization/core/part_options.hpp"
#include "services/localization/core/scan_agreement.hpp"
#include "services/localization/core/scan_continuity.hpp"
#include "services/localization/core/scan_search.hpp"

namespace tandem {
namespace {

constexpr double kFieldReachM = 2.0;      ///< Distances beyond this say nothing about where a wall is.
constexpr std::size_t kMinReturns = 20;   ///< Fewer beams do not tell one place from another.
constexpr double kClearlyBetter = 0.05;   ///< Gain of agreement for which a searched pose is taken.
constexpr double kSuddenDrop = 0.05;      ///< Below the mean of the last scans by this, a scan fits badly.
constexpr double kSearchedShare = 0.5;    ///< Share of the particles put at a searched pose.
constexpr double kSlipM = 0.3;            ///< A correction this large is motion that the wheels missed.
constexpr double kFastestMps = 5.0;       ///< No robot of ours drives faster, ...
constexpr double kFastestRadps = 8.0;     ///< ... or turns faster.
constexpr double kShortestS = 0.1;        ///< Stamps of samples close together are not exact.
constexpr double kNewTimeS = 2.0;         ///< Scans older than the last one by more than this, ...
constexpr int kScansOfNewTime = 5;        ///< ... so many in a row, are of a time that began anew.
constexpr int kNoEpoch = -1;              ///< Of no odometry.
constexpr double kReconciledShare = 0.5;  ///< Of `break_above`: two scans that contradict each other less agree.
constexpr double kFirstWorkS = 0.1;       ///< What the first input is worth to a search, ...
constexpr double kLongestWorkS = 0.5;     ///< ... and at most any other.

}  // namespace

Localizer::Localizer(OccupancyGrid map, const LocalizationConfig& config)
    : config_(config),
      map_(std::move(map)),
      distances_(map_, kFieldReachM),
      likelihoods_(map_, distances_, BeamModel{config.hit_deviation_m, config.random_share}),
      finder_(map_, likelihoods_, finder_options(config)),
      setup_(setup_options(config, map_.resolution_m())),
      window_(distances_, window_options(config, map_.resolution_m())),
      rng_(static_cast<std::uint64_t>(config.seed)),
      odometry_(from_seconds(config.odometry_max_age_s)),
      monitor_(config.agreement_ok, from_seconds(config.lost_after_s)) {}

void Localizer::add_odometry(const OdometrySample& sample) {
  switch (odometry_.add(sample)) {
    case OdometryOrder::InOrder:
      break;
    case OdometryOrder::Late:
      faults_.add(InputFault::OdometryOutOfOrder);
      break;
    case OdometryOrder::WentBack:
      faults_.add(InputFault::TimeWentBack);
      break;
  }
  search(search_budget(sample.time));
}

std::size_t Localizer::search_budget(Time time) {
  const double passed_s = worked_at_ ? to_seconds(time - *worked_at_) : kFirstWorkS;
  worked_at_ = time;
  return static_cast<std::size_t>(config_.search_boxes_per_s * std::clamp(passed_s, 0.0, kLongestWorkS));
}

void Localizer::add_hint(const PoseHint& hint) {
  hint_ = hint;
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
  const MotionDeviation deviation = deviation_of(motion, config_.wheels.times(factor));
  move(particles_, motion, deviation, rng_);
  last_ = odometry;
  return {motion, deviation};
}

PoseFit Localizer::tracked(const Cluster& group, const Pose2& motion, const MotionDeviation& deviation) {
  RefinedPose pose{group.map_from_base, group.covariance};
  if (config_.window_scans > 0) pose = window_.add(pose, endpoints_, motion, deviation);
  return {pose, agreement_at(pose.map_from_base)};
}

PoseFit Localizer::fit_at(const Pose2& map_from_base) const {
  const RefinedPose refined = refine_pose(distances_, endpoints_, map_from_base, refinement_options(config_));
  return {refined, agreement_at(refined.map_from_base)};
}

double Localizer::agreement_at(const Pose2& map_from_base) const {
  return agreement_of(map_, distances_, map_from_base, base_from_laser_.position(), endpoints_, config_.fit_distance_m);
}

PoseFit Localizer::corrected(PoseFit fit, const Pose2& expected, Time time) {
  slipped_ = broken_off_;
  if (!trusted_) return fit;  // lost: the finder looks everywhere
  const bool fits = fit.agreement >= std::max(config_.search_below, mean_agreement_ - kSuddenDrop);
  if (fits && !broken_off_) return fit;
  const SearchWindow window{.half_side_m = config_.search_window_m,
                            .half_turn_rad = config_.search_window_rad,
                            .prior_weight = config_.search_prior_weight};
  const Pose2 found = best_pose_in_window(likelihoods_, few_endpoints_, fit.pose.map_from_base, window);
  const PoseFit searched = fit_at(found);
  if (searched.agreement < fit.agreement + kClearlyBetter) return fit;
  slipped_ = slipped_ || (searched.pose.map_from_base.position() - expected.position()).norm() > kSlipM;
  window_.restart();
  gather(particles_, kSearchedShare, searched.pose.map_from_base, 0.1, 0.05, rng_);
  normalise(particles_);
  distrust_until_ = time + from_seconds(config_.distrust_s);
  return searched;
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

bool Localizer::is_late(Time scan_time) {
  if (!last_ || scan_time >= last_->time) {
    late_scans_ = 0;
    return false;
  }
  if (last_->time - scan_time < from_seconds(kNewTimeS) || ++late_scans_ < kScansOfNewTime) return true;
  // The clock was set back: what is known of the past stays, but its times say nothing.
  late_scans_ = 0;
  last_->time = scan_time;
  last_->epoch = kNoEpoch;
  distrust_until_ = Time{Duration::min()};
  monitor_.reset();
  return false;
}

std::optional<LocalizationResult> Localizer::add_scan(const LaserScan& scan) {
  const bool thinned_out = config_.scans == "odd" && scan_count_ % 2 == 0;
  ++scan_count_;
  if (thinned_out) return std::nullopt;  // as if it had never been there
  const auto odometry = odometry_.at(scan.time);
  if (!odometry) return refused(InputFault::ScanWithoutOdometry);
  if (is_late(scan.time)) return refused(InputFault::ScanOutOfOrder);
  if (const auto fault = scan_check_.fault_of(scan, odometry->odom_from_base)) return refused(*fault);
  budget_ = search_budget(scan.time);
  base_from_laser_ = scan.base_from_laser;
  endpoints_ = selected_endpoints(scan, static_cast<std::size_t>(config_.refine_beams), config_.range_limit_m,
                                  odometry->velocity);
  if (endpoints_.size() < kMinReturns) return refused(InputFault::ScanWithTooFewReturns);
  few_endpoints_ = thinned(endpoints_, static_cast<std::size_t>(config_.filter_beams));

  if (particles_.empty()) last_ = *odometry;
  apply_hint();
  if (!is_started()) return std::nullopt;
  if (particles_.empty()) start_at(*odometry);
  if (particles_.empty()) return sought(*odometry);
  broken_off_ = breaks_off(*odometry);
  if (const auto resting = fit_at_rest(*odometry)) return claim(*odometry, *resting, {});

  const auto [motion, deviation] = predict(*odometry);
  compare_with_mirrored();
  weigh(particles_, likelihoods_, few_endpoints_, config_.beam_weight);
  const auto groups = clusters(particles_, 3);
  const Pose2 expected = last_fit_ ? last_fit_->pose.map_from_base * motion : groups.front().map_from_base;
  const PoseFit fit = judged(corrected(tracked(groups.front(), motion, deviation), expected, scan.time), *odometry);
  resample(fit);
  last_fit_ = fit;
  const auto others = trusted_ ? other_groups(groups) : other_places(finder_.finding(), fit.pose.map_from_base);
  return claim(*odometry, fit, others);
}

bool Localizer::breaks_off(const OdometrySample& odometry) const {
  if (!seen_ || !trusted_) return false;
  const bool counts_on = seen_->odometry.epoch == odometry.epoch;
  const Pose2 motion = counts_on ? inverse(seen_->odometry.odom_from_base) * odometry.odom_from_base : Pose2{};
  return contradiction_of(seen_->endpoints_in_base, endpoints_, base_from_laser_.position(), motion,
                          deviation_of(motion, config_.wheels)) > config_.break_above;
}

bool Localizer::is_reconciled(const PoseFit& fit) const {
  const Pose2 motion = inverse(seen_->map_from_base) * fit.pose.map_from_base;
  return contradiction_of(seen_->endpoints_in_base, endpoints_, base_from_laser_.position(), motion, {}) <
         kReconciledShare * config_.break_above;
}

std::optional<PoseFit> Localizer::fit_at_rest(const OdometrySample& odometry) const {
  if (broken_off_ || !last_fit_ || status_ != LocalizationStatus::Ok || !trusted_ || last_->epoch != odometry.epoch) {
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

LocalizationResult Localizer::claim(const OdometrySample& odometry, const PoseFit& fit,
                                    const std::vector<PoseHypothesis>& others) {
  const bool on_probation = finder_.way_m() - probation_from_m_ < config_.place_certain_m;
  const bool doubtful = !trusted_ || may_be_carried_ || on_probation || setup_.fault();
  const bool claims_too_much = doubtful && status_ == LocalizationStatus::Ok;
  seen_ = {endpoints_, odometry, fit.pose.map_from_base};
  last_result_ = {result_of(odometry, fit, claims_too_much ? LocalizationStatus::Uncertain : status_, others),
                  odometry};
  return last_result_->result;
}

std::optional<LocalizationResult> Localizer::predicted_now() const {
  const auto now = odometry_.newest();
  if (!now || !last_result_) return std::nullopt;
  MotionNoise noise = config_.wheels;
  noise.drift_m = 0.0;  // that of an update, however short the time to it
  noise.drift_rad = 0.0;
  return predicted(*last_result_, *now, noise, from_seconds(config_.prediction_max_age_s));
}

}  // namespace tandem
