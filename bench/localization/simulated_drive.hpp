#pragma once

#include <cstdint>
#include <vector>

#include "bench/localization/recorded_log.hpp"
#include "services/localization/core/motion_model.hpp"

namespace tandem::bench {

/// How a simulated drive is made.
struct DriveOptions {
  double way_m = 30.0;
  double step_s = 0.2;                       ///< between scans
  double range_deviation_m = 0.02;           ///< of a beam's range
  double random_share = 0.03;                ///< beams that end at something that is not on the map
  double resolution_m = 0.05;                ///< of the map that is drawn from the walls
  bool corridor = false;                     ///< a long corridor with blank walls instead of a furnished hall
  MotionNoise wheels = kUncalibratedWheels;  ///< how the odometry errs
};

/// A robot in a hall of straight walls at random angles: its truth is exact, its scans are cast against the walls
/// themselves and not against the map. Equal seed, equal drive.
[[nodiscard]] RecordedLog simulated_drive(std::uint64_t seed, const DriveOptions& options);

}  // namespace tandem::bench
