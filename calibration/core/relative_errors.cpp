#include "calibration/core/relative_errors.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "calibration/core/median.hpp"
#include "calibration/core/wheel_motion.hpp"

namespace tandem {
namespace {

/// The laser's motion by the wheels between two poses.
std::optional<Pose2> by_wheels(const OdometryTrack& odometry, const WheelUse& use, Time from, Time to) {
  const Duration clock = from_seconds(use.laser_clock_s);
  const auto wheels = wheel_motion(odometry, from + clock, to + clock);
  if (!wheels) return std::nullopt;
  Pose2 motion;
  for (const Arc<double>& step : wheels->steps) {
    const Arc<double> end = chord_of(corrected<double>(step, use.half_track_m, use.wheels.left_wheel_scale,
                                                       use.wheels.right_wheel_scale, use.wheels.track_scale));
    motion = motion * Pose2{end.forward_m, end.left_m, end.turn_rad};
  }
  return inverse(use.base_from_laser) * motion * use.base_from_laser;
}

bool touches(const TimeWindows& windows, Time from, Time to) {
  const double first = to_seconds(from.time_since_epoch());
  const double last = to_seconds(to.time_since_epoch());
  return std::any_of(windows.begin(), windows.end(),
                     [&](const auto& window) { return first <= window.second && last >= window.first; });
}

}  // namespace

RelativeErrors relative_errors_of(const OdometryTrack& odometry, const WheelUse& use,
                                  std::span<const TimedPose> world_from_laser, double way_m,
                                  const TimeWindows& excluded) {
  std::vector<double> way_to{0.0};
  for (std::size_t i = 1; i < world_from_laser.size(); ++i) {
    const Pose2 step = inverse(world_from_laser[i - 1].map_from_base) * world_from_laser[i].map_from_base;
    way_to.push_back(way_to.back() + step.position().norm());
  }
  std::vector<double> metres;
  std::vector<double> degrees;
  std::size_t end = 0;
  for (std::size_t i = 0; i < world_from_laser.size(); ++i) {
    while (end < way_to.size() && way_to[end] - way_to[i] < way_m) ++end;
    if (end == way_to.size()) break;
    const TimedPose& from = world_from_laser[i];
    const TimedPose& to = world_from_laser[end];
    if (touches(excluded, from.time, to.time)) continue;
    const auto motion = by_wheels(odometry, use, from.time, to.time);
    if (!motion) continue;
    const Pose2 off = inverse(inverse(from.map_from_base) * to.map_from_base) * *motion;
    metres.push_back(off.position().norm());
    degrees.push_back(to_degrees(std::abs(off.heading)));
  }
  return {.stretches = metres.size(), .median_m = median(metres), .median_deg = median(degrees)};
}

}  // namespace tandem
