#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/localization/core/agreement_monitor.hpp"
#include "services/localization/core/trajectory_file.hpp"

namespace tandem {

/// A pose that was estimated, with what the localizer thought of it.
struct EstimatedPose {
  TimedPose pose;
  Covariance3 covariance = Covariance3::Zero();
  LocalizationStatus status = LocalizationStatus::Ok;
};

/// How far estimates are from a reference; benchmarks define these. Nothing is counted where the reference is silent.
struct TrajectoryErrors {
  std::size_t compared = 0;
  double rmse_m = 0.0;
  double rmse_deg = 0.0;
  double rmse_kept_m = 0.0;  ///< without the excluded windows of time
  double median_m = 0.0;
  double max_m = 0.0;
  double lost_share = 0.0;          ///< more than 1 m off
  double nees = 0.0;                ///< mean normalised squared error over its expectation, 3: 1 is honest
  double status_wrong_share = 0.0;  ///< ok although more than 0.5 m or 10 degrees off, or not ok although nearer
};

/// Windows of time [s], closed.
using TimeWindows = std::vector<std::pair<double, double>>;

/// Compares each estimate with the reference at its time plus `truth_offset_s`. `truth` is ordered by time.
[[nodiscard]] TrajectoryErrors errors_of(std::span<const EstimatedPose> estimates, std::span<const TimedPose> truth,
                                         double truth_offset_s, const TimeWindows& excluded);

/// The pose at `time` between those of `poses` (ordered by time); none outside them.
[[nodiscard]] std::optional<Pose2> pose_at(std::span<const TimedPose> poses, Time time);

/// A surveyed relative pose: where the robot was at `to`, seen from where it was at `from`.
struct Relation {
  Time from{};
  Time to{};
  Pose2 from_pose_to_pose;
};

/// Lines of `t1 t2 dx dy dz droll dpitch dyaw` (Kuemmerle et al. 2009).
[[nodiscard]] std::vector<Relation> parse_relations(const std::string& text, const std::string& file_name);

struct RelationErrors {
  std::size_t compared = 0;
  double mean_m = 0.0;
  double deviation_m = 0.0;
  double mean_deg = 0.0;
  double deviation_deg = 0.0;
};

/// Errors, in position and in heading, of the estimates' relative poses; relation time is an estimate's time plus
/// `truth_offset_s`.
[[nodiscard]] RelationErrors relation_errors_of(std::span<const TimedPose> estimates,
                                                std::span<const Relation> relations, double truth_offset_s);

/// How well the estimates have the form of a reference whose origin is elsewhere.
struct FormErrors {
  std::size_t compared = 0;
  double rmse_m = 0.0;
  double max_m = 0.0;
  Pose2 truth_from_map{};  ///< lays the estimates onto the truth with the least squares of distances
};

/// Lays the estimates onto the truth as a whole, and compares positions. `truth` is ordered by time.
[[nodiscard]] FormErrors form_errors_of(std::span<const TimedPose> estimates, std::span<const TimedPose> truth,
                                        double truth_offset_s);

}  // namespace tandem
