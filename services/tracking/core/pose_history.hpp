#pragma once

#include <deque>
#include <optional>

#include "services/common/pose2.hpp"
#include "services/common/time.hpp"

namespace tandem::tracking {

/// Where the robot was in the last seconds: poses in order of their stamps, interpolated between.
class PoseHistory {
 public:
  PoseHistory(Duration length, Duration max_extrapolation) : length_(length), max_extrapolation_(max_extrapolation) {}

  /// Adds a pose. One that is not newer than the last is left out.
  void add(Time stamp, const Pose2& pose);
  /// The pose at `time`: between two neighbours, or going on from the last two for a little. None outside of that.
  [[nodiscard]] std::optional<Pose2> at(Time time) const;
  /// True once at(time) no longer changes with what is added.
  [[nodiscard]] bool covers(Time time) const;

 private:
  struct Entry {
    Time stamp;
    Pose2 pose;
  };
  Duration length_;
  Duration max_extrapolation_;
  std::deque<Entry> entries_;
};

}  // namespace tandem::tracking
