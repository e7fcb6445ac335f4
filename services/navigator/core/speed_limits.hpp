#pragma once

#include <vector>

#include "services/navigator/core/avoidance.hpp"
#include "services/navigator/core/navigator.hpp"
#include "services/navigator/core/navigator_config.hpp"

namespace tandem::navigator {

/// The greatest speed [m/s] for `course`: by the free way, the curve, the goal, narrow views (SAF-3) and people who are
/// come up to from behind (SAF-3). The safety gate has the last word on all of them but the goal.
[[nodiscard]] double speed_limit(const NavigatorConfig& config, const Course& course, const Aim& aim,
                                 const Pose2& map_from_base, PoseQuality quality,
                                 const std::vector<WalkingPerson>& people);

/// True for a person ahead within `distance_m` who walks away from the robot and so does not see it.
[[nodiscard]] bool comes_up_from_behind(const Pose2& map_from_base, const WalkingPerson& person, double distance_m);

/// `wanted` as far as the acceleration limits allow within one period after `last`. Slowing down is never held back:
/// the gate does that. `measured_mps` keeps the command from running ahead of wheels that do not follow.
[[nodiscard]] Twist2 limited_acceleration(const NavigatorConfig& config, const Twist2& last, const Twist2& wanted,
                                          double measured_mps);

}  // namespace tandem::navigator
