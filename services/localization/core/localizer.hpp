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
#include "services/localization/core/localization_config.hpp"
#include "services/localization/core/localization_result.hpp"
#include "services/localization/core/odometry_history.hpp"
#include "services/localization/core/particles.hpp"
#include "services/localization/core/place_finder.hpp"
#include "services/localization/core/pose_prediction.hpp"
#include "services/localization/core/pose_refinement.hpp"
#include "services/localization/core/scan_check.hpp"
#include "services/localization/core/setup_check.hpp"
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

/// Where the robot was when localization ended.
struct RememberedPose {
  Pose2 map_from_base;
  Pose2 odom_from_base;    ///< what the wheels said there ...
  int odometry_epoch = 0;  ///< ... and in which epoch
};

/// How far a remembered pose is believed once the first scan agrees with it.
enum class Memory {
  Fresh,  ///< written seconds ago: nobody carried the robot away
  Old     ///< the robot may stand in a place that looks alike: Uncertain, until the search of the whole map is certain
};

/// What became of a remembered pose.
enum class MemoryOutcome { None, Awaited, Agreed, Refused };

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

  /// The robot may still be there: taken as the start pose if the next scan agrees, else forgotten.
  void restore(const RememberedPose& pose, Memory memory);
  [[nodiscard]] MemoryOutcome memory_outcome() const { return memory_outcome_; }

  /// The last scan's pose, carried on by the wheels to the newest odometry; none where they do not tell (see
  /// predicted()). Changes nothing.
  [[nodiscard]] std::optional<LocalizationResult> predicted_now() const;
  /// The last pose that add_scan gave.
  [[nodiscard]] const std::optional<OdometryResult>& last_result() const { return last_result_; }

  /// What came in that could not be used as it was.
  [[nodiscard]] const InputFaults& faults() const { return faults_; }
  /// Counts what never got here, because it was not even a message of numbers.
  void add_fault(InputFault fault) { faults_.add(fault); }
  /// LaserMirrored or MapScaleWrong, while scans fit the map clearly better that way.
  [[nodiscard]] std::optional<InputFault> setup_fault() const { return setup_.fault(); }
  /// With MapScaleWrong: how many times too long the map's lengths are.
  [[nodiscard]] double map_scale() const { return setup_.map_scale(); }

  /// Has it a pose to start from, right or wrong?
  [[nodiscard]] bool is_started() const {
    return !particles_.empty() || config_.start_globally || !config_.start.empty() || remembered_;
  }

 private:
  /// A scan, and where it was taken.
  struct Seen {
    std::vector<Eigen::Vector2d> endpoints_in_base;
    OdometrySample odometry;
    Pose2 map_from_base;
  };

  /// How many boxes may be scored since the input before, so that a search never holds up the poses for long.
  [[nodiscard]] std::size_t search_budget(Time time);
  /// Takes notice of `fault`: there is no pose for this scan.
  std::nullopt_t refused(InputFault fault);
  /// Older than the last one, and not one of many after a time that began anew?
  [[nodiscard]] bool is_late(Time scan_time);
  /// Without a pose: starts at the remembered one if the scan agrees, else at the configured one.
  void start_at(const OdometrySample& odometry);
  [[nodiscard]] bool starts_where_remembered(const OdometrySample& odometry);
  void apply_hint();
  /// Does the scan at hand contradict the last one: was the robot carried, or moved further than the wheels say?
  [[nodiscard]] bool breaks_off(const OdometrySample& odometry) const;
  /// Does the scan at hand agree with the last one if the robot moved from the last pose to that of `fit`?
  [[nodiscard]] bool is_reconciled(const PoseFit& fit) const;
  /// Moves the particles; the motion and how wrong it may be.
  std::pair<Pose2, MotionDeviation> predict(const OdometrySample& odometry);
  /// The filter's pose, refined together with the last ones.
  [[nodiscard]] PoseFit tracked(const Cluster& group, const Pose2& motion, const MotionDeviation& deviation);
  [[nodiscard]] PoseFit fit_at(const Pose2& map_from_base) const;
  [[nodiscard]] double agreement_at(const Pose2& map_from_base) const;
  /// `fit`, or a pose near it that fits much better: wheels missed some motion, which is a slip where that pose is far
  /// from the one `expected` by the wheels.
  [[nodiscard]] PoseFit corrected(PoseFit fit, const Pose2& expected, Time time);
  /// Keeps the panorama: it must not hold what was seen from two places with an unknown motion between.
  void remember(const OdometrySample& odometry, bool broken);
  /// Takes the agreement of `fit`, and decides whether it is still the place.
  [[nodiscard]] PoseFit judged(PoseFit fit, const OdometrySample& odometry);
  /// Is the whole map to be looked at?
  [[nodiscard]] bool wants_places();
  /// Goes on with the search of the whole map; once that has answered, with that for a wrong setup.
  void search(std::size_t boxes);
  /// Soon after a start the pose is known: does the scan at hand fit there clearly better with left and right
  /// exchanged?
  void compare_with_mirrored();
  /// While the laser or the map is set up so wrongly that no place can be right, none is beyond doubt.
  void note_setup();
  /// The pose at a place that was found, by the scan at hand.
  [[nodiscard]] PoseFit settled_at(const Pose2& place) const;
  void believe(const PoseFit& fit);
  void resample(const PoseFit& fit);
  /// Without a start pose: what the finder says, until it is certain.
  [[nodiscard]] std::optional<LocalizationResult> sought(const OdometrySample& odometry);
  /// The pose of a robot that stands still and learns nothing new; none if it moves or the scan does not fit.
  [[nodiscard]] std::optional<PoseFit> fit_at_rest(const OdometrySample& odometry) const;
  /// What is claimed of `fit`: not ok while anything was wrong lately, or while `others` are possible.
  [[nodiscard]] LocalizationResult claim(const OdometrySample& odometry, const PoseFit& fit,
                                         const std::vector<PoseHypothesis>& others);

  LocalizationConfig config_;
  OccupancyGrid map_;
  DistanceField distances_;
  LikelihoodField likelihoods_;
  PlaceFinder finder_;
  SetupCheck setup_;
  SlidingWindow window_;
  Rng rng_;
  OdometryHistory odometry_;
  AgreementMonitor monitor_;
  LocalizationStatus status_ = LocalizationStatus::Lost;
  Particles particles_;
  std::optional<OdometrySample> last_;  ///< where the wheels were when the particles were last moved
  std::optional<PoseFit> last_fit_;     ///< the pose then
  Time distrust_until_{Duration::min()};
  bool trusted_ = true;                       ///< is the place beyond doubt, whatever the last scan says?
  bool slipped_ = false;                      ///< did the last scan show motion that the wheels missed?
  bool broken_off_ = false;                   ///< does the scan at hand contradict the one before?
  bool may_be_carried_ = false;               ///< ... did one, and nothing has told since that it is the same place?
  double mean_agreement_ = 1.0;               ///< of the last scans
  double probation_from_m_ = -1e9;            ///< finder_.way_m() when a scan last did not fit, or showed missed motion
  double started_at_m_ = 0.0;                 ///< finder_.way_m() when it came to the place that it follows
  int mirrored_fits_ = 0;                     ///< scans in a row that fitted better mirrored
  double doubted_at_m_ = 0.0;                 ///< finder_.way_m() when other places were last asked for, ...
  bool doubting_ = false;                     ///< ... and is the answer still to come?
  std::optional<Time> worked_at_;             ///< when the last input came
  std::size_t budget_ = 0;                    ///< for the scan at hand [boxes]
  std::optional<double> place_score_;         ///< of the best place, while the setup is in doubt
  std::optional<PoseHint> hint_;              ///< not yet applied
  std::optional<RememberedPose> remembered_;  ///< not yet compared
  Memory memory_ = Memory::Old;
  MemoryOutcome memory_outcome_ = MemoryOutcome::None;
  std::optional<OdometryResult> last_result_;
  InputFaults faults_;
  ScanCheck scan_check_;
  int late_scans_ = 0;  ///< in a row
  std::int64_t scan_count_ = 0;
  Pose2 base_from_laser_;
  std::vector<Eigen::Vector2d> endpoints_;      ///< of the scan at hand, in the base frame
  std::vector<Eigen::Vector2d> few_endpoints_;  ///< those that weigh the particles
  std::optional<Seen> seen_;                    ///< by the scan before
};

}  // namespace tandem
