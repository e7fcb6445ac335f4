#pragma once

#include <vector>

#include "services/common/pose2.hpp"
#include "services/common/time.hpp"
#include "services/localization/core/agreement_monitor.hpp"
#include "services/localization/core/odometry_history.hpp"
#include "services/localization/core/particles.hpp"
#include "services/localization/core/place_finder.hpp"
#include "services/localization/core/pose_refinement.hpp"

namespace tandem {

/// A pose, and how well the scan at hand fits the map there.
struct PoseFit {
  RefinedPose pose;
  double agreement = 0.0;  ///< [0, 1] share of beams that fit the map
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

/// The groups of particles but the first, which `groups` lists as the heaviest; none when that one leaves no doubt.
[[nodiscard]] std::vector<PoseHypothesis> other_groups(const std::vector<Cluster>& groups);

/// The places of `finding` that are not the one of `here`.
[[nodiscard]] std::vector<PoseHypothesis> other_places(const Finding& finding, const Pose2& here);

/// What is known at the time of `odometry`. The pose of `fit` is one of the hypotheses, with the weight that `others`
/// leave; while there are others, it is Uncertain at best.
[[nodiscard]] LocalizationResult result_of(const OdometrySample& odometry, const PoseFit& fit,
                                           LocalizationStatus status, const std::vector<PoseHypothesis>& others);

}  // namespace tandem
