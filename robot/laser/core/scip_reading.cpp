#include "robot/laser/core/scip_reading.hpp"

#include <algorithm>
#include <limits>

namespace tandem {

LaserReading reading_of(const scip::ScanData& scan, const scip::SensorParameters& sensor, Time index_mark,
                        double range_max_m) {
  const int steps = scip::steps_per_value(scan.request);
  const double first_beam_step = scan.request.first_step + (steps - 1) / 2.0;
  const double step_interval_s = scip::turn_period_s(sensor) / sensor.steps_per_turn;

  LaserReading reading;
  reading.first_beam = index_mark + from_seconds(first_beam_step * step_interval_s);
  reading.angle_min_rad = scip::angle_of_step(sensor, first_beam_step);
  reading.angle_increment_rad =
      scip::angle_of_step(sensor, first_beam_step + steps) - scip::angle_of_step(sensor, first_beam_step);
  reading.scan_period_s = scip::turn_period_s(sensor);
  reading.beam_interval_s = steps * step_interval_s;
  reading.range_min_m = sensor.range_min_mm * 1e-3;
  reading.range_max_m = std::min(sensor.range_max_mm * 1e-3, range_max_m);

  const auto metres = [&](std::uint32_t range_mm) {
    const double range_m = range_mm * 1e-3;
    const bool usable = range_m >= reading.range_min_m && range_m <= reading.range_max_m;
    return usable ? static_cast<float>(range_m) : std::numeric_limits<float>::quiet_NaN();
  };
  reading.ranges_m.resize(scan.ranges_mm.size());
  std::transform(scan.ranges_mm.begin(), scan.ranges_mm.end(), reading.ranges_m.begin(), metres);
  reading.intensities.assign(scan.intensities.begin(), scan.intensities.end());
  return reading;
}

}  // namespace tandem
