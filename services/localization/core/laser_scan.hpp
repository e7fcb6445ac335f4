#pragma once

#include <vector>

#include "services/common/pose2.hpp"
#include "services/common/time.hpp"

namespace tandem {

/// One turn of the laser.
struct LaserScan {
  Time time{};  ///< of the first beam
  Pose2 base_from_laser{};
  double angle_min_rad = 0.0;  ///< of the first beam in the laser frame, counter-clockwise positive
  double angle_increment_rad = 0.0;
  double beam_interval_s = 0.0;  ///< from one beam to the next
  double range_min_m = 0.0;
  double range_max_m = 0.0;
  std::vector<float> ranges_m{};  ///< NaN: no return or unusable
};

}  // namespace tandem
