#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/common/random.hpp"
#include "services/common/time.hpp"
#include "services/localization/core/agreement_monitor.hpp"
#include "services/localization/core/input_faults.hpp"
#include "services/localization/core/laser_scan.hpp"
#include "services/localization/core/likelihood_field.hpp"
#include "services/localization/core/localization_result.hpp"
#include "services/localization/core/localization_config.hpp"
#include "services/localization/core/odometry_history.hpp"
#include "services/localization/core/particles.hpp"
#include "services/localization/core/place_finder.hpp"
#include "services/localization/core/pose_refinement.hpp"
#include "services/localization/core/sliding_window.hpp"
#include "services/mapping/core/distance_field.hpp"
#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem {

/// A person says where the robot is.
struct PoseHint {
  Time time{};
  Pose2 map_from_base;
  bool heading_known = true;
  double standard_deviation_m = 0.5;
};

/// Odometry, scans and a map in; poses out. The same inputs in the same order give the same poses, bit for bit.
///
/// A particle filter on a likelihood field follows the robot; Ceres refines its best pose; where the scan does not fit
/// the map, the surroundings are searched exhaustively. See docs/localization.md.
class Localizer {
 public:
  Localizer(OccupancyGrid map, const LocalizationConfig& config);

  void add_odometry(const OdometrySample& sample);
  /// The pose at the scan's time. None while there is no start pose, without odometry at that time, for a scan that is
  /// thinned out, and for one with too few returns.
  [[nodiscard]] std::optional<LocalizationResult> add_scan(const LaserScan& scan);
  /// The robot is about there: at the next scan particles gather around it, and that scan decides.
  void add_hint(const PoseHint& hint);

  /// What came in that could not be used as it was.
  [[nodiscard]] const InputFaults& faults() const { return faults_; }

  /// Does it follow a pose, right or wrong?
  [[nodiscard]] bool is_started() const { return !particles_.empty() || config_.start_globally; }

 private:
  /// Takes notice of `fault`: there is no pose for this scan.
  std::nullopt_t refused(InputFault fault);
  [[nodiscard]] bool is_stuck(const LaserScan& scan, const OdometrySample& odometry);
  void start_at(const OdometrySample& odometry);
  void apply_hint();
  /// Moves the particles; the motion and how wrong it may be.
  std::pair<Pose2, MotionDeviation> predict(const OdometrySample& odometry);
  /// The filter's pose, refined together with the last ones.
  [[nodiscard]] PoseFit tracked(const Cluster& group, const Pose2& motion, const MotionDeviation& deviation);
  [[nodiscard]] PoseFit fit_at(const Pose2& map_from_base) const;
  [[nodiscard]] double agreement_at(const Pose2& map_from_base) const;
  /// `fit`, or a pose near it that fits much better: wheels missed some motion.
  [[nodiscard]] PoseFit corrected(PoseFit fit, Time time);
  /// Keeps the panorama: it must not hold what was seen from two places with an unknown motion between.
  void remember(const OdometrySample& odometry, bool broken);
  /// Takes the agreement of `fit`, and decides whether it is still the place.
  [[nodiscard]] PoseFit judged(PoseFit fit, const OdometrySample& odometry);
  [[nodiscard]] bool is_in_doubt();
  /// The pose at a place that was found, by the scan at hand.
  [[nodiscard]] PoseFit settled_at(const Pose2& place) const;
  void believe(const PoseFit& fit);
  void resample(const PoseFit& fit);
  /// Without a start pose: what the finder says, until it is certain.
  [[nodiscard]] std::optional<LocalizationResult> sought(const OdometrySample& odometry);
  /// The pose of a robot that stands still and learns nothing new; none if it moves or the scan does not fit.
  [[nodiscard]] std::optional<PoseFit> fit_at_rest(const OdometrySample& odometry) const;
  /// What is claimed of `fit`: not ok while anything was wrong lately, or while `others` are possible.
  [[nodiscard]] LocalizationResult claimed(const OdometrySample& odometry, const PoseFit& fit,
                                           const std::vector<PoseHypothesis>& others) const;

  LocalizationConfig config_;
  OccupancyGrid map_;
  DistanceField distances_;
  LikelihoodField likelihoods_;
  PlaceFinder finder_;
  SlidingWindow window_;
  Rng rng_;
  OdometryHistory odometry_;
  AgreementMonitor monitor_;
  LocalizationStatus status_ = LocalizationStatus::Lost;
  Particles particles_;
  std::optional<OdometrySample> last_;  ///< where the wheels were when the particles were last moved
  std::optional<PoseFit> last_fit_;         ///< the pose then
  Time distrust_until_{Duration::min()};
  bool trusted_ = true;             ///< is the place beyond doubt, whatever the last scan says?
  bool slipped_ = false;            ///< did the last scan show motion that the wheels missed?
  double mean_agreement_ = 1.0;     ///< of the last scans
  double probation_from_m_ = -1e9;  ///< finder_.way_m() when a scan last did not fit, or showed missed motion
  double doubted_at_m_ = 0.0;       ///< finder_.way_m() when other places were last looked at
  std::optional<PoseHint> hint_;    ///< not yet applied
  InputFaults faults_;
  std::vector<float> seen_ranges_m_;  ///< of the last scan that differed from the one before ...
  Pose2 seen_at_;                     ///< ... and where the wheels were then
  std::int64_t scan_count_ = 0;
  Eigen::Vector2d laser_in_base_ = Eigen::Vector2d::Zero();
  std::vector<Eigen::Vector2d> endpoints_;      ///< of the scan at hand, in the base frame
  std::vector<Eigen::Vector2d> few_endpoints_;  ///< those that weigh the particles
};

}  // namespace tandem
