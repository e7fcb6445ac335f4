#include "robot/laser/core/lms_reading.hpp"

#include <algorithm>
#include <limits>

#include "services/common/angle.hpp"

namespace tandem {
namespace {

constexpr double kBitsPerByte = 10.0;  // 8N1
constexpr double kFramingBytes = 6.0 + 4.0;

}  // namespace

DeviceScan device_scan_of(const lms::ScanData& scan, const lms::Variant& variant, const lms::RangeFormat& format,
                          int baud_rate, double range_max_m) {
  const double step_deg = variant.step_centideg * 0.01;
  const double unit_m = scan.millimetres ? 0.001 : 0.01;
  const unsigned range_mask = (1U << lms::range_bits(format)) - 1U;
  const double sensor_max_m = lms::range_max_m({format.measuring_mode, scan.millimetres});

  DeviceScan out;
  LaserReading& reading = out.reading;
  reading.angle_min_rad = from_degrees(-variant.field_deg / 2.0);
  reading.angle_increment_rad = from_degrees(step_deg);
  reading.scan_period_s = lms::kTurnPeriod_s;
  reading.beam_interval_s = lms::kTurnPeriod_s * step_deg / 360.0;
  reading.range_min_m = unit_m;
  reading.range_max_m = std::min(range_max_m, sensor_max_m);
  reading.ranges_m.reserve(scan.values.size());
  for (const std::uint16_t value : scan.values) {
    const double range_m = (value & range_mask) * unit_m;
    const bool usable = range_m >= reading.range_min_m && range_m <= reading.range_max_m;
    reading.ranges_m.push_back(usable ? static_cast<float>(range_m) : std::numeric_limits<float>::quiet_NaN());
    if (lms::has_intensity(format)) {
      reading.intensities.push_back(static_cast<float>(value >> lms::range_bits(format)));
    }
  }
  const int turns = lms::turns_per_scan(variant);
  const double sweep_s = lms::kTurnPeriod_s * variant.field_deg / 360.0;
  const double bytes = kFramingBytes + 2.0 * static_cast<double>(scan.values.size());
  const double sending_s = baud_rate > 0 ? bytes * kBitsPerByte / baud_rate : 0.0;
  out.least_delay = from_seconds(sending_s);
  out.mark_to_first_beam = from_seconds(-sweep_s - (turns - 1) / 2.0 * lms::kTurnPeriod_s);
  const double scan_s = turns * lms::kTurnPeriod_s;
  out.period_s = std::max(scan_s, sending_s);
  return out;
}

}  // namespace tandem
