#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/localization/core/laser_scan.hpp"

namespace tandem {

/// Where at most `count` beams of `scan` end, in the base frame at the scan's time [m].
///
/// Chosen evenly among the beams that returned within the scan's range limits and `range_limit_m`. The base moves at
/// `velocity` while the laser turns; that is taken out.
[[nodiscard]] std::vector<Eigen::Vector2d> selected_endpoints(const LaserScan& scan, std::size_t count,
                                                              double range_limit_m, const Twist2& velocity);

/// Evenly spread ones of `all`, `count` at most.
template <typename T>
[[nodiscard]] std::vector<T> evenly(std::span<const T> all, std::size_t count) {
  if (all.size() <= count) return {all.begin(), all.end()};
  std::vector<T> chosen;
  chosen.reserve(count);
  for (std::size_t i = 0; i < count; ++i) chosen.push_back(all[(2 * i + 1) * all.size() / (2 * count)]);
  return chosen;
}

/// Every n-th of `points`, so that at most `count` are left.
[[nodiscard]] std::vector<Eigen::Vector2d> thinned(std::span<const Eigen::Vector2d> points, std::size_t count);

}  // namespace tandem
