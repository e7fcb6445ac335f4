#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "services/localization/core/odometry_history.hpp"

namespace tandem {

/// The odometry of a whole recording, by time.
///
/// Recorded stamps are often those of the receiver: held up, they come in bursts, and some step back. What came earlier
/// is not later: a sample that has a later stamp than one that follows gets that one's time. Samples of one time are
/// spread over what it was rounded to.
class OdometryTrack {
 public:
  OdometryTrack() = default;
  /// `samples` are in the order in which they came.
  explicit OdometryTrack(std::vector<OdometrySample> samples);

  /// The pose at `time`: interpolated between two samples however far apart; at a break, and after the end, the sample
  /// before carried on with its velocity, for `max_extrapolation` at most. Its epoch names the unbroken stretch.
  [[nodiscard]] std::optional<OdometrySample> at(Time time, Duration max_extrapolation) const;

  /// By time, as many and in the same order as they came; the epoch names the unbroken stretch.
  [[nodiscard]] std::span<const OdometrySample> samples() const { return samples_; }
  /// The stamp that each of samples() was recorded with, spread where several are equal: others know the sample by it.
  [[nodiscard]] std::span<const Time> stamps() const { return stamps_; }
  /// How often the wheels went faster than any robot: there the track breaks, as it does where the base says so.
  [[nodiscard]] std::size_t jumps() const { return jumps_; }

 private:
  std::vector<OdometrySample> samples_;
  std::vector<Time> stamps_;
  std::size_t jumps_ = 0;
};

}  // namespace tandem
