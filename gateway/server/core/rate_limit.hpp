#pragma once

#include <algorithm>

#include "services/common/time.hpp"

namespace tandem::gateway {

/// A bucket of `burst` that fills with `rate_per_s`; each permission takes one out.
class RateLimit {
 public:
  RateLimit(double rate_per_s, double burst, Time now)
      : rate_per_s_(rate_per_s), burst_(burst), level_(burst), last_(now) {}

  [[nodiscard]] bool allows(Time now) {
    level_ = std::min(burst_, level_ + std::max(0.0, to_seconds(now - last_)) * rate_per_s_);
    last_ = now;
    if (level_ < 1.0) return false;
    level_ -= 1.0;
    return true;
  }

 private:
  double rate_per_s_;
  double burst_;
  double level_;
  Time last_;
};

}  // namespace tandem::gateway
