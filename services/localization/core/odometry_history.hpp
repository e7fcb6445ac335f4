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

/// The last few seconds of odometry, to ask for the pose at a scan's time.
class OdometryHistory {
 public:
  explicit OdometryHistory(Duration max_extrapolation) : max_extrapolation_(max_extrapolation) {}

  /// Takes samples in any order, the newest of equal times; a new epoch forgets the one before.
  void add(const OdometrySample& sample);

  /// The pose at `time`: between two samples interpolated, after the last one carried on with its velocity.
  ///
  /// None before the first sample, or further after the last than the limit. A gap is interpolated however long.
  [[nodiscard]] std::optional<OdometrySample> at(Time time) const;

 private:
  Duration max_extrapolation_;
  std::deque<OdometrySample> samples_;  ///< by time, all of one epoch
};

/// The motion in the base's own frame after `duration` at constant `velocity`.
[[nodiscard]] Pose2 motion_of(const Twist2& velocity, Duration duration);

}  // namespace tandem
