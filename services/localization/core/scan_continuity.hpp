#pragma once

#include <Eigen/Core>
#include <span>

#include "services/common/pose2.hpp"
#include "services/localization/core/motion_model.hpp"

namespace tandem {

/// Share of the beams of two successive scans that cannot both be true; 0 where too few can be compared.
///
/// A beam contradicts the other scan where it ends in what that one saw to be free. Where the robot is moves neither
/// walls nor furniture: a large share means that it was carried, or moved further than the wheels say, whatever the map
/// may look like at either place. People who walk by make a small one.
///
/// `before` and `now` are where the beams end in the base frame of their scan [m], `laser_in_base` where they start;
/// `before_from_now` is the motion that the wheels tell, `deviation` how wrong that may be: nothing is held against a
/// beam that it explains.
[[nodiscard]] double contradiction_of(std::span<const Eigen::Vector2d> before, std::span<const Eigen::Vector2d> now,
                                      const Eigen::Vector2d& laser_in_base, const Pose2& before_from_now,
                                      const MotionDeviation& deviation);

}  // namespace tandem
