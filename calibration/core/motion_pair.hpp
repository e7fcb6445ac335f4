#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "services/map_builder/core/drive_log.hpp"

namespace tandem {

/// How far the robot moved from one scan to a later one, as the two scans say when they are laid onto each other.
///
/// `motion` is that of the base as the recording places the laser on it: another place of the laser gives another
/// motion, and by that the laser is found.
struct MotionPair {
  Time from{};  ///< stamps of the scans
  Time to{};
  Pose2 motion{};
  Covariance3 covariance = Covariance3::Zero();  ///< of the motion, in the frame of its end
  double matched_share = 0.0;                    ///< of the later scan's points
};

/// How pairs are made.
struct PairOptions {
  double way_m = 0.4;           ///< A pair ends when the wheels say that the robot went this far ...
  double turn_rad = 0.4;        ///< ... or turned this far,
  double longest_s = 5.0;       ///< and is left out when that took longer.
  double least_share = 0.5;     ///< Scans that match less tell nothing.
  double range_limit_m = 30.0;  ///< Longer beams are not used.
  std::size_t points = 360;     ///< of a scan
};

/// The pairs of a drive, each beginning where the one before ended. A robot that stood, and a stretch that the odometry
/// does not cover, are left out. `keep_going` hears the share done; after a false there are no more.
[[nodiscard]] std::vector<MotionPair> motion_pairs(const Drive& drive, const PairOptions& options,
                                                   const std::function<bool(double)>& keep_going);

}  // namespace tandem
