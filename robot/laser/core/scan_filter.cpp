#include "robot/laser/core/scan_filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "services/common/angle.hpp"

namespace tandem {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr int kScansOfDirt = 50;                            // whoever stands there moves before
constexpr double kMostWidthOfDirt_rad = from_degrees(3.0);  // of a spot

/// The angle between the beam of range `range_m` and the line from its end to that of a beam `step_rad` beside it.
double angle_to_beam_rad(double range_m, double neighbour_m, double step_rad) {
  return std::atan2(neighbour_m * std::sin(step_rad), std::abs(neighbour_m * std::cos(step_rad) - range_m));
}

}  // namespace

void ScanFilter::apply(LaserReading& reading) {
  if (dirt_range_m_ > 0.0) take_dirt_away(reading);
  if (veil_angle_rad_ > 0.0) take_veils_away(reading);
}

void ScanFilter::take_veils_away(LaserReading& reading) const {
  const std::vector<float> ranges = reading.ranges_m;  // as measured: one veil must not hide the next
  const double step_rad = std::abs(reading.angle_increment_rad);
  for (std::size_t i = 1; i + 1 < ranges.size(); ++i) {
    const double before = ranges[i - 1];
    const double here = ranges[i];
    const double after = ranges[i + 1];
    const bool between = (before < here && here < after) || (before > here && here > after);  // false with a NaN
    if (between && angle_to_beam_rad(here, before, step_rad) < veil_angle_rad_ &&
        angle_to_beam_rad(here, after, step_rad) < veil_angle_rad_) {
      reading.ranges_m[i] = kNone;
    }
  }
}

void ScanFilter::take_dirt_away(LaserReading& reading) {
  auto& ranges = reading.ranges_m;
  if (near_in_a_row_.size() != ranges.size()) near_in_a_row_.assign(ranges.size(), 0);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    near_in_a_row_[i] = ranges[i] <= dirt_range_m_ ? std::min(near_in_a_row_[i] + 1, kScansOfDirt) : 0;
  }
  dirty_beams_ = 0;
  const double step_rad = std::abs(reading.angle_increment_rad);
  for (std::size_t from = 0; from < ranges.size();) {
    std::size_t to = from;
    bool all_old = true;
    for (; to < ranges.size() && near_in_a_row_[to] > 0; ++to) all_old = all_old && near_in_a_row_[to] == kScansOfDirt;
    const bool is_spot = to > from && all_old && static_cast<double>(to - from) * step_rad <= kMostWidthOfDirt_rad;
    if (is_spot) {
      dirty_beams_ += static_cast<int>(to - from);
      std::fill(ranges.begin() + static_cast<std::ptrdiff_t>(from), ranges.begin() + static_cast<std::ptrdiff_t>(to),
                kNone);
    }
    from = to + 1;
  }
}

std::string ScanFilter::complaint() const {
  if (dirty_beams_ == 0) return "";
  return std::to_string(dirty_beams_) + " beams end at the window: clean it";
}

}  // namespace tandem
