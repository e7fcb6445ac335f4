#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "services/tracking/core/leg_detection.hpp"

namespace tandem::tracking {

/// A round leg, 12 cm across.
struct RoundLeg {
  Eigen::Vector2d position{0.0, 0.0};
  double radius_m = 0.06;
};

/// The legs of people who stand across the line of sight of a laser on the x axis, 0.3 m between them.
inline std::vector<RoundLeg> all_legs(const std::vector<Eigen::Vector2d>& people) {
  std::vector<RoundLeg> legs;
  for (const auto& person : people) {
    legs.push_back({person + Eigen::Vector2d{0.0, 0.15}});
    legs.push_back({person - Eigen::Vector2d{0.0, 0.15}});
  }
  return legs;
}

/// What a laser at the origin, looking along x, sees of `legs` in front of a round wall: 361 beams over 270 degrees.
inline LaserScan scan_of(const std::vector<RoundLeg>& legs, double wall_m = 25.0) {
  LaserScan scan;
  scan.angle_min_rad = from_degrees(-135.0);
  scan.angle_increment_rad = from_degrees(0.75);
  scan.range_min_m = 0.05;
  scan.range_max_m = 30.0;
  for (int i = 0; i < 361; ++i) {
    const double bearing = scan.angle_min_rad + i * scan.angle_increment_rad;
    const Eigen::Vector2d ray{std::cos(bearing), std::sin(bearing)};
    double range = wall_m;
    for (const auto& leg : legs) {
      const double along = ray.dot(leg.position);
      const double square = leg.radius_m * leg.radius_m - (leg.position.squaredNorm() - along * along);
      if (along > 0.0 && square >= 0.0) range = std::min(range, along - std::sqrt(square));
    }
    scan.ranges_m.push_back(static_cast<float>(range));
  }
  return scan;
}

}  // namespace tandem::tracking
