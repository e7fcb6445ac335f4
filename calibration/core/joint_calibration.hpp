#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "calibration/core/motion_pair.hpp"
#include "services/common/wheel_correction.hpp"

namespace tandem {

/// What is calibrated, in the order of a covariance's rows.
enum class CalibrationParameter { LeftWheel, RightWheel, Track, LaserX, LaserY, LaserHeading, LaserClock };
inline constexpr int kCalibrationParameters = 7;
using CalibrationCovariance = Eigen::Matrix<double, kCalibrationParameters, kCalibrationParameters>;

/// What is known before.
struct CalibrationStart {
  Pose2 base_from_laser{};    ///< as the recording has it
  double half_track_m = 0.2;  ///< that the recorded odometry counts with
  bool hold_wheels = false;   ///< They are right already: only the laser is looked for.
};

/// How well one pair of scans agrees with the wheels.
struct PairResidual {
  Time from{};
  double way_m = 0.0;     ///< between the scans, by them
  double turn_rad = 0.0;  ///< likewise
  Eigen::Vector3d before =
      Eigen::Vector3d::Zero();  ///< ahead [m], to the left [m], turn [rad]: the wheels minus the scans, uncalibrated
  Eigen::Vector3d after = Eigen::Vector3d::Zero();  ///< calibrated
  double weight = 1.0;  ///< [0, 1]; near 0: the wheels slipped, or the scans were laid wrongly
};

/// What is known afterwards.
struct JointCalibration {
  WheelCorrection wheels;      ///< of the recorded odometry: on top of what it was corrected by already
  Pose2 base_from_laser;       ///< on the true base
  double laser_clock_s = 0.0;  ///< to add to the laser's stamps, so that they are of the base's clock
  CalibrationCovariance covariance = CalibrationCovariance::Zero();  ///< zero rows where held
  Eigen::Vector3d spread = Eigen::Vector3d::Zero();  ///< of the residuals after: robust standard deviations
  std::vector<PairResidual> residuals;

  [[nodiscard]] double deviation(CalibrationParameter parameter) const;
};

/// The corrections of the wheels, the laser's place and its clock that make wheels and scans agree best, all at once.
///
/// Robust against slipping wheels (Cauchy). The noise is taken from the residuals, and the covariance from how the
/// residuals pull in fact, neighbouring pairs together: they share a scan.
[[nodiscard]] JointCalibration calibrated(const OdometryTrack& odometry, std::span<const MotionPair> pairs,
                                          const CalibrationStart& start);

}  // namespace tandem
