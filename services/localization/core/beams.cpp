#include "services/localization/core/beams.hpp"

#include <cmath>

#include "services/localization/core/odometry_history.hpp"

namespace tandem {
std::vector<Eigen::Vector2d> thinned(std::span<const Eigen::Vector2d> points, std::size_t count) {
  return evenly(points, count);
}

std::vector<Eigen::Vector2d> selected_endpoints(const LaserScan& scan, std::size_t count, double range_limit_m,
                                                const Twist2& velocity) {
  const double longest_m = std::min(scan.range_max_m, range_limit_m);
  std::vector<std::size_t> returned;
  for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
    const double range = scan.ranges_m[i];
    if (range >= scan.range_min_m && range > 0.0 && range < longest_m) returned.push_back(i);  // NaN is neither
  }
  std::vector<Eigen::Vector2d> endpoints;
  for (const std::size_t i : evenly(std::span<const std::size_t>{returned}, count)) {
    const double angle = scan.angle_min_rad + static_cast<double>(i) * scan.angle_increment_rad;
    const double range = scan.ranges_m[i];
    const Pose2 motion = motion_of(velocity, from_seconds(static_cast<double>(i) * scan.beam_interval_s));
    endpoints.push_back(motion *
                        (scan.base_from_laser * Eigen::Vector2d{range * std::cos(angle), range * std::sin(angle)}));
  }
  return endpoints;
}

}  // namespace tandem
