#pragma once

#include <deque>
#include <optional>

#include "services/common/pose2.hpp"
#include "services/common/time.hpp"

namespace tandem {

/// What the wheels said at one time.
struct OdometrySample {
  Time time{};
  Pose2 odom_from_base;
  Twist2 velocity;
  int epoch = 0;  ///< Poses of two epochs do not compare.
};

/// How a sample relates to those before.
enum class OdometryOrder {
  InOrder,
  Late,      ///< older than the newest, and put in its place
  WentBack,  ///< older by more than is kept: time began anew, and the past is forgotten
};

/// The last few seconds of odometry, to ask for the pose at a scan's time.
class OdometryHistory {
 public:
  explicit OdometryHistory(Duration max_extrapolation) : max_extrapolation_(max_extrapolation) {}

  /// Takes samples in any order, the newest of equal times; a new epoch forgets the one before, and so does a time
  /// more than 5 s from that of the newest sample.
  OdometryOrder add(const OdometrySample& sample);

  /// The pose at `time`: between two samples interpolated, after the last one carried on with its velocity.
  ///
  /// None before the first sample, or further after the last than the limit. A gap of up to 5 s is interpolated.
  [[nodiscard]] std::optional<OdometrySample> at(Time time) const;
  /// The one with the latest time.
  [[nodiscard]] std::optional<OdometrySample> newest() const;

 private:
  Duration max_extrapolation_;
  std::deque<OdometrySample> samples_;  ///< by time, all of one epoch
};

/// The motion in the base's own frame after `duration` at constant `velocity`.
[[nodiscard]] Pose2 motion_of(const Twist2& velocity, Duration duration);

}  // namespace tandem
