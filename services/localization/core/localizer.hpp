#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/common/random.hpp"
#include "services/common/time.hpp"
#include "services/localization/core/agreement_monitor.hpp"
#include "services/localization/core/laser_scan.hpp"
#include "services/localization/core/likelihood_field.hpp"
#include "services/localization/core/localization_config.hpp"
#include "services/localization/core/odometry_history.hpp"
#include "services/localization/core/particles.hpp"
#include "services/localization/core/pose_refinement.hpp"
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

/// One place where the robot may be.
struct PoseHypothesis {
  Pose2 map_from_base;
  double weight = 0.0;  ///< [0, 1]
};

/// Where the robot was at the time of a scan.
struct LocalizationResult {
  Time time{};
  int odometry_epoch = 0;
  Pose2 map_from_base;
  Covariance3 covariance = Covariance3::Zero();
  double agreement = 0.0;  ///< [0, 1] share of beams that fit the map
  LocalizationStatus status = LocalizationStatus::Lost;
  std::vector<PoseHypothesis> hypotheses;  ///< heaviest first; one when certain
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

  /// Does it follow a pose, right or wrong?
  [[nodiscard]] bool is_started() const { return !particles_.empty(); }

 private:
  struct Fit {
    RefinedPose pose;
    double agreement = 0.0;
  };

  void start_at(const OdometrySample& odometry);
  void apply_hint();
  void predict(const OdometrySample& odometry);
  [[nodiscard]] Fit fit_at(const Pose2& map_from_base) const;
  [[nodiscard]] Fit corrected(Fit fit, Time time);
  void resample(const Fit& fit);
  void seek_everywhere();
  /// The result where a robot that stands still learns nothing new; none if it moves or the scan does not fit.
  [[nodiscard]] std::optional<LocalizationResult> result_at_rest(const OdometrySample& odometry);
  [[nodiscard]] LocalizationResult result_of(const Fit& fit, const std::vector<Cluster>& groups) const;

  LocalizationConfig config_;
  OccupancyGrid map_;
  DistanceField distances_;
  LikelihoodField likelihoods_;
  Rng rng_;
  OdometryHistory odometry_;
  AgreementMonitor monitor_;
  LocalizationStatus status_ = LocalizationStatus::Lost;
  Particles particles_;
  std::optional<OdometrySample> last_;  ///< where the wheels were when the particles were last moved
  std::optional<Fit> last_fit_;         ///< the pose then
  Time distrust_until_{Duration::min()};
  std::optional<PoseHint> hint_;  ///< not yet applied
  std::int64_t scan_count_ = 0;
  std::vector<Eigen::Vector2d> endpoints_;      ///< of the scan at hand, in the base frame
  std::vector<Eigen::Vector2d> few_endpoints_;  ///< those that weigh the particles
};

}  // namespace tandem
