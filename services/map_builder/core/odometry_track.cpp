#include "services/map_builder/core/odometry_track.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tandem {
namespace {

constexpr double kFastestMps = 5.0;    ///< No robot of ours drives faster, ...
constexpr double kFastestRadps = 8.0;  ///< ... or turns faster.
constexpr double kShortestS = 0.1;     ///< Stamps of samples close together are not exact.

constexpr Duration kRounding = std::chrono::milliseconds{10};  ///< Old logs round their stamps so.

/// No time is later than one that follows.
void let_none_step_back(std::vector<Time>& times) {
  for (std::size_t i = times.size(); i-- > 1;) times[i - 1] = std::min(times[i - 1], times[i]);
}

/// Equal times in a row are spread around theirs, no further than half way to those before and after.
void spread_equal(std::vector<Time>& times) {
  Time before = Time::min();
  for (std::size_t first = 0; first < times.size();) {
    const Time time = times[first];
    std::size_t end = first;
    while (end < times.size() && times[end] == time) ++end;
    Duration width = kRounding;
    if (first > 0 && before < time) width = std::min(width, time - before);
    if (end < times.size() && times[end] > time) width = std::min(width, times[end] - time);
    const auto count = static_cast<std::int64_t>(end - first);
    for (std::int64_t i = 0; i < count; ++i) {
      times[first + static_cast<std::size_t>(i)] += width * (2 * i + 1 - count) / (2 * count);
    }
    before = time;
    first = end;
  }
}

bool is_jump(const OdometrySample& before, const OdometrySample& after) {
  const Pose2 motion = inverse(before.odom_from_base) * after.odom_from_base;
  const double seconds = std::max(kShortestS, to_seconds(after.time - before.time));
  return motion.position().norm() > kFastestMps * seconds || std::abs(motion.heading) > kFastestRadps * seconds;
}

}  // namespace

OdometryTrack::OdometryTrack(std::vector<OdometrySample> samples) : samples_(std::move(samples)) {
  for (const OdometrySample& sample : samples_) stamps_.push_back(sample.time);
  std::vector<Time> times = stamps_;
  spread_equal(stamps_);
  let_none_step_back(times);
  spread_equal(times);
  for (std::size_t i = 0; i < times.size(); ++i) samples_[i].time = times[i];
  int stretch = 0;
  int epoch = 0;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    if (i > 0) {
      const bool jump = samples_[i].epoch == epoch && is_jump(samples_[i - 1], samples_[i]);
      jumps_ += jump ? 1 : 0;
      if (jump || samples_[i].epoch != epoch) ++stretch;
    }
    epoch = std::exchange(samples_[i].epoch, stretch);
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
