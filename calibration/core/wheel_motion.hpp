#pragma once

#include <optional>

#include "calibration/core/motion_residual.hpp"
#include "services/map_builder/core/odometry_track.hpp"

namespace tandem {

/// What the wheels report from `from` to `to`; none where the odometry breaks, or does not reach.
[[nodiscard]] std::optional<WheelMotion> wheel_motion(const OdometryTrack& odometry, Time from, Time to);

}  // namespace tandem
