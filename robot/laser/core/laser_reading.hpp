#pragma once

#include <vector>

#include "services/common/time.hpp"

namespace tandem {

/// One scan in SI units, beams counter-clockwise from the right.
struct LaserReading {
  Time first_beam{};           ///< when the first beam was measured
  double angle_min_rad = 0.0;  ///< of the first beam in the laser frame
  double angle_increment_rad = 0.0;
  double scan_period_s = 0.0;    ///< for a whole turn
  double beam_interval_s = 0.0;  ///< from one beam to the next
  double range_min_m = 0.0;
  double range_max_m = 0.0;
  std::vector<float> ranges_m;     ///< NaN: no return or unusable
  std::vector<float> intensities;  ///< empty where the laser gives none
};

}  // namespace tandem
