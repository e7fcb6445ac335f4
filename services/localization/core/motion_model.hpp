#pragma once

#include <cmath>

#include "services/common/pose2.hpp"
#include "services/common/random.hpp"
#include "services/localization/core/motion_noise.hpp"

namespace tandem {

/// Standard deviations of one motion.
struct MotionDeviation {
  double forward_m = 0.0;
  double sideways_m = 0.0;
  double turn_rad = 0.0;
};

[[nodiscard]] inline MotionDeviation deviation_of(const Pose2& before_from_after, const MotionNoise& noise) {
  const double way = before_from_after.position().norm();
  const double turn = std::abs(before_from_after.heading);
  return {std::hypot(noise.forward_per_m * way, noise.drift_m), std::hypot(noise.sideways_per_m * way, noise.drift_m),
          std::sqrt(std::pow(noise.turn_per_rad * turn, 2) + std::pow(noise.turn_per_m * way, 2) +
                    std::pow(noise.drift_rad, 2))};
}

/// A motion that the wheels may have reported as `before_from_after`.
[[nodiscard]] inline Pose2 sampled_motion(const Pose2& before_from_after, const MotionDeviation& deviation, Rng& rng) {
  const double forward = rng.normal(0.0, deviation.forward_m);
  const double sideways = rng.normal(0.0, deviation.sideways_m);
  const double turn = rng.normal(0.0, deviation.turn_rad);
  return before_from_after * Pose2{forward, sideways, turn};
}

}  // namespace tandem
