#pragma once

#include <algorithm>
#include <limits>

#include "services/common/time.hpp"

namespace tandem::gateway {

/// How long the messages of one connection were on their way, beyond the quickest: a Wi-Fi that comes back delivers
/// what was sent into the hole long ago. Needs no common clock.
class Transit {
 public:
  /// How much later than the quickest so far [ms] a message arrived that was sent at `sent_at_ms` of the phone's clock.
  double late_ms(double sent_at_ms, Time arrived) {
    const double offset_ms = 1000.0 * to_seconds(arrived.time_since_epoch()) - sent_at_ms;
    least_ms_ = std::min(least_ms_, offset_ms);
    return offset_ms - least_ms_;
  }

 private:
  double least_ms_ = std::numeric_limits<double>::infinity();
};

}  // namespace tandem::gateway
