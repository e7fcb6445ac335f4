#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "services/localization/core/odometry_history.hpp"

namespace tandem {

/// The odometry of a whole recording, by time.
class OdometryTrack {
 public:
  OdometryTrack() = default;
  /// Takes samples in any order; of equal times the last one counts.
  explicit OdometryTrack(std::vector<OdometrySample> samples);

  /// The pose at `time`: interpolated between two samples however far apart; at a break, and after the end, the sample
  /// before carried on with its velocity, for `max_extrapolation` at most. Its epoch names the unbroken stretch.
  [[nodiscard]] std::optional<OdometrySample> at(Time time, Duration max_extrapolation) const;

  /// By time; the epoch names the unbroken stretch.
  [[nodiscard]] std::span<const OdometrySample> samples() const { return samples_; }
  /// How often the wheels went faster than any robot: there the track breaks, as it does where the base says so.
  [[nodiscard]] std::size_t jumps() const { return jumps_; }

 private:
  std::vector<OdometrySample> samples_;
  std::size_t jumps_ = 0;
};

}  // namespace tandem
