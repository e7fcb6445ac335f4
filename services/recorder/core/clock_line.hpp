#pragma once

#include <cstdint>
#include <vector>

namespace tandem::recorder {

/// One measurement of how far another clock is ahead of ours.
struct OffsetSample {
  std::uint64_t time_ns = 0;  ///< when, by our clock
  double offset_s = 0.0;      ///< the other clock minus ours [s]
};

/// How far another clock is ahead of ours, over time: the median of each minute of measurements, and straight lines
/// between those; before the first and behind the last as at these. A single bad measurement moves nothing.
class ClockLine {
 public:
  /// A clock that is always `offset_s` ahead.
  explicit ClockLine(double offset_s) : knots_{{0, offset_s}} {}
  /// `samples` in any order, at least one.
  explicit ClockLine(std::vector<OffsetSample> samples);

  [[nodiscard]] double offset_s_at(std::uint64_t time_ns) const;

 private:
  std::vector<OffsetSample> knots_;
};

}  // namespace tandem::recorder
