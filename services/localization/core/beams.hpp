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

/// Every n-th of `points`, so that at most `count` are left.
[[nodiscard]] std::vector<Eigen::Vector2d> thinned(std::span<const Eigen::Vector2d> points, std::size_t count);

}  // namespace tandem
