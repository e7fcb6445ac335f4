#pragma once

#include <span>
#include <vector>

#include "calibration/core/joint_calibration.hpp"
#include "services/localization/core/trajectory_errors.hpp"

namespace tandem {

/// How far dead reckoning goes wrong over a length of way: medians over all stretches that long.
struct RelativeErrors {
  std::size_t stretches = 0;
  double median_m = 0.0;
  double median_deg = 0.0;
};

/// What is taken for the robot's wheels, its laser and the clock, to dead-reckon with.
struct WheelUse {
  WheelCorrection wheels{};
  Pose2 base_from_laser{};
  double laser_clock_s = 0.0;
  double half_track_m = 0.2;
};

/// Compares the laser's motion by the wheels with `world_from_laser` (by time, the laser's stamps), over each stretch
/// of `way_m` that begins at one of these poses; stretches that touch one of `excluded` [s] are left out.
[[nodiscard]] RelativeErrors relative_errors_of(const OdometryTrack& odometry, const WheelUse& use,
                                                std::span<const TimedPose> world_from_laser, double way_m,
                                                const TimeWindows& excluded);

}  // namespace tandem
