#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <utility>
#include <vector>

#include "services/recorder/core/arrival.hpp"

namespace tandem::recorder {

/// The time before an event, kept in memory until there is one: all that came within the last `span`, and in front of
/// it the last word of each State that is older, so that the recording can be replayed by itself.
class PreRoll {
 public:
  /// With more than `limit_bytes` of payload the span is shorter.
  PreRoll(Duration span, std::size_t limit_bytes) : span_(span), limit_bytes_(limit_bytes) {}

  /// Arrivals come in order of `received`. `is_state`: of a topic whose last sample per instance holds on.
  void keep(Arrival arrival, bool is_state);
  /// All that is kept, in order.
  [[nodiscard]] std::vector<Arrival> everything() const;
  /// What came so far has been recorded: of it only the States are kept.
  void settle();

  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  struct Kept {
    Arrival arrival;
    bool is_state = false;
  };
  void age_oldest();

  Duration span_;
  std::size_t limit_bytes_;
  std::deque<Kept> recent_;
  std::map<std::pair<std::size_t, KeyBytes>, Arrival> states_;  ///< older than the span, by topic and instance
  std::size_t bytes_ = 0;                                       ///< of payload in recent_
};

}  // namespace tandem::recorder
