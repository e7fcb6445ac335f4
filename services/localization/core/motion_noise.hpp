#pragma once

#include "services/common/config.hpp"

namespace tandem {

/// How wrong the odometry of a skid-steered base can be: standard deviations that grow with the motion.
///
/// The one place of these fields: part of localization.toml and of a map builder's configuration alike.
struct MotionNoise {
  double forward_per_m = 0.0;   ///< of the distance per metre driven
  double sideways_per_m = 0.0;  ///< of the drift sideways per metre driven
  double turn_per_rad = 0.0;    ///< of the turn per radian turned [rad]
  double turn_per_m = 0.0;      ///< of the turn per metre driven [rad]
  double drift_m = 0.0;         ///< of the position at each step, however small the motion
  double drift_rad = 0.0;       ///< of the heading at each step

  [[nodiscard]] MotionNoise times(double factor) const {
    return {factor * forward_per_m, factor * sideways_per_m, factor * turn_per_rad,
            factor * turn_per_m,    factor * drift_m,        factor * drift_rad};
  }

  template <typename Visitor>
  void visit_fields(Visitor& visitor) {
    const Range share{0.0, 1.0};
    visitor.field("forward_per_m", forward_per_m, share);
    visitor.field("sideways_per_m", sideways_per_m, share);
    visitor.field("turn_per_rad", turn_per_rad, share);
    visitor.field("turn_per_m", turn_per_m, share);
    visitor.field("drift_m", drift_m, share);
    visitor.field("drift_rad", drift_rad, share);
  }
};

/// What is believed of wheels that nobody has calibrated.
inline constexpr MotionNoise kUncalibratedWheels{.forward_per_m = 0.12,
                                                 .sideways_per_m = 0.05,
                                                 .turn_per_rad = 0.12,
                                                 .turn_per_m = 0.06,
                                                 .drift_m = 0.01,
                                                 .drift_rad = 0.005};

}  // namespace tandem
