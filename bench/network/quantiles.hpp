#pragma once

#include <algorithm>
#include <vector>

#include "bench/planning/statistics/statistics.hpp"
#include "services/common/time.hpp"

namespace tandem::bench {

[[nodiscard]] inline double to_ms(Duration duration) {
  return to_seconds(duration) * 1e3;
}

/// The largest value below which `share` of all lie; `none` if there are none. Unlike quantile(), a value that
/// occurred.
[[nodiscard]] inline double observed_quantile(std::vector<double> values, double share, double none) {
  if (values.empty()) return none;
  std::sort(values.begin(), values.end());
  const auto index = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.999999);
  return values[std::min(index, values.size() - 1)];
}

}  // namespace tandem::bench
