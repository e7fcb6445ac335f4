#include "services/localization/core/odometry_history.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {
namespace {

constexpr Duration kKept = std::chrono::seconds{5};

bool is_earlier(const OdometrySample& sample, Time time) {
  return sample.time < time;
}

}  // namespace

Pose2 motion_of(const Twist2& velocity, Duration duration) {
  const double seconds = to_seconds(duration);
  const double turn = velocity.turn_rate_radps * seconds;
  const Pose2 half_turn{0.0, 0.0, turn / 2.0};  // along the chord of the arc
  const Eigen::Vector2d way = half_turn * Eigen::Vector2d{velocity.forward_mps * seconds, velocity.left_mps * seconds};
  return {way.x(), way.y(), wrap_to_pi(turn)};
}

OdometryOrder OdometryHistory::add(const OdometrySample& sample) {
  OdometryOrder order = OdometryOrder::InOrder;
  if (!samples_.empty() && samples_.back().epoch != sample.epoch) samples_.clear();
  if (!samples_.empty()) {
    const Duration ahead = sample.time - samples_.back().time;
    if (ahead < Duration::zero()) order = ahead < -kKept ? OdometryOrder::WentBack : OdometryOrder::Late;
    // One wrong stamp must not stay the newest for ever.
    if (ahead > kKept || ahead < -kKept) samples_.clear();
  }
  auto place = std::lower_bound(samples_.begin(), samples_.end(), sample.time, is_earlier);
  if (place != samples_.end() && place->time == sample.time) {
    *place = sample;
  } else {
    samples_.insert(place, sample);
  }
  while (samples_.back().time - samples_.front().time > kKept && samples_.size() > 2) samples_.pop_front();
  return order;
}

std::optional<OdometrySample> OdometryHistory::newest() const {
  if (samples_.empty()) return std::nullopt;
  return samples_.back();
}

std::optional<OdometrySample> OdometryHistory::at(Time time) const {
  if (samples_.empty() || time < samples_.front().time) return std::nullopt;
  const auto after = std::lower_bound(samples_.begin(), samples_.end(), time, is_earlier);
  if (after == samples_.end()) {
    OdometrySample last = samples_.back();
    if (time - last.time > max_extrapolation_) return std::nullopt;
    last.odom_from_base = last.odom_from_base * motion_of(last.velocity, time - last.time);
    last.time = time;
    return last;
  }
  if (after->time == time) return *after;
  const OdometrySample& before = *std::prev(after);
  const double share = to_seconds(time - before.time) / to_seconds(after->time - before.time);
  OdometrySample between = before;
  between.time = time;
  between.odom_from_base = interpolate(before.odom_from_base, after->odom_from_base, share);
  return between;
}

}  // namespace tandem
