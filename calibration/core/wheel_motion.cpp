#include "calibration/core/wheel_motion.hpp"

#include <algorithm>

namespace tandem {
namespace {

/// The rate of the step during which `time` lies; it lies between two samples.
Arc<double> rate_at(const OdometryTrack& odometry, Time time) {
  const auto samples = odometry.samples();
  auto after = std::upper_bound(samples.begin(), samples.end(), time,
                                [](Time wanted, const OdometrySample& sample) { return wanted < sample.time; });
  if (after == samples.end()) --after;
  const OdometrySample& before = *std::prev(after);
  const double seconds = to_seconds(after->time - before.time);
  if (seconds <= 0.0 || after->epoch != before.epoch) return {};
  const Arc<double> arc = arc_to(inverse(before.odom_from_base) * after->odom_from_base);
  return {arc.forward_m / seconds, arc.left_m / seconds, arc.turn_rad / seconds};
}

}  // namespace

std::optional<WheelMotion> wheel_motion(const OdometryTrack& odometry, Time from, Time to) {
  const auto start = odometry.at(from, Duration::zero());
  const auto end = odometry.at(to, Duration::zero());
  if (!start || !end || start->epoch != end->epoch) return std::nullopt;
  const auto samples = odometry.samples();
  auto sample = std::upper_bound(samples.begin(), samples.end(), from,
                                 [](Time wanted, const OdometrySample& one) { return wanted < one.time; });
  WheelMotion motion{.steps = {}, .rate_at_start = rate_at(odometry, from), .rate_at_end = rate_at(odometry, to)};
  Pose2 last = start->odom_from_base;
  for (; sample != samples.end() && sample->time < to; ++sample) {
    motion.steps.push_back(arc_to(inverse(last) * sample->odom_from_base));
    last = sample->odom_from_base;
  }
  motion.steps.push_back(arc_to(inverse(last) * end->odom_from_base));
  return motion;
}

}  // namespace tandem
