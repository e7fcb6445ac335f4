#include "services/map_builder/core/odometry_track.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {
namespace {

constexpr double kFastestMps = 5.0;    ///< No robot of ours drives faster, ...
constexpr double kFastestRadps = 8.0;  ///< ... or turns faster.
constexpr double kShortestS = 0.1;     ///< Stamps of samples close together are not exact.

bool is_jump(const OdometrySample& before, const OdometrySample& after) {
  const Pose2 motion = inverse(before.odom_from_base) * after.odom_from_base;
  const double seconds = std::max(kShortestS, to_seconds(after.time - before.time));
  return motion.position().norm() > kFastestMps * seconds || std::abs(motion.heading) > kFastestRadps * seconds;
}

}  // namespace

OdometryTrack::OdometryTrack(std::vector<OdometrySample> samples) {
  std::stable_sort(samples.begin(), samples.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  int stretch = 0;
  int epoch = 0;
  for (const OdometrySample& sample : samples) {
    if (!samples_.empty()) {
      OdometrySample& last = samples_.back();
      const bool same_epoch = epoch == sample.epoch;
      if (same_epoch && last.time == sample.time) {
        last = sample;
        last.epoch = stretch;
        continue;
      }
      const bool jump = same_epoch && is_jump(last, sample);
      jumps_ += jump ? 1 : 0;
      if (!same_epoch || jump) ++stretch;
    }
    epoch = sample.epoch;
    samples_.push_back(sample);
    samples_.back().epoch = stretch;
  }
}

std::optional<OdometrySample> OdometryTrack::at(Time time, Duration max_extrapolation) const {
  const auto after = std::upper_bound(samples_.begin(), samples_.end(), time,
                                      [](Time wanted, const OdometrySample& sample) { return wanted < sample.time; });
  if (after == samples_.begin()) return std::nullopt;
  OdometrySample found = *std::prev(after);
  const Duration since = time - found.time;
  if (after == samples_.end() || after->epoch != found.epoch) {
    if (since > max_extrapolation) return std::nullopt;
    found.odom_from_base = found.odom_from_base * motion_of(found.velocity, since);
  } else if (since > Duration::zero()) {
    const double share = to_seconds(since) / to_seconds(after->time - found.time);
    found.odom_from_base = interpolate(found.odom_from_base, after->odom_from_base, share);
  }
  found.time = time;
  return found;
}

}  // namespace tandem
