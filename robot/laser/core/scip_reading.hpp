#pragma once

#include "robot/laser/core/laser_reading.hpp"
#include "robot/laser/core/scip.hpp"
#include "services/common/time.hpp"

namespace tandem {

/// `scan` of `sensor`, whose index mark passed at `index_mark`.
///
/// A range below the sensor's least is an error code, one above its greatest or `range_max_m` no return: both are NaN.
/// A beam of several steps points to the middle of them.
[[nodiscard]] LaserReading reading_of(const scip::ScanData& scan, const scip::SensorParameters& sensor, Time index_mark,
                                      double range_max_m);

}  // namespace tandem
