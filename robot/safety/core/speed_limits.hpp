#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "robot/safety/core/gate_config.hpp"
#include "robot/safety/core/motion_monitor.hpp"
#include "robot/safety/core/swept_path.hpp"

namespace tandem::safety {

/// Where people are.
struct PeopleInput {
  std::span<const Eigen::Vector2d> in_base;  ///< tracked persons [m]
  std::optional<double> age_s;               ///< of the list; none if there never was one
};

/// SAF-2: the speed allowed with the nearest person at `distance_m` from the hull; steps, no interpolation.
[[nodiscard]] double speed_near_person(double distance_m, double otherwise_mps);

/// The distance from the hull to the nearest person; infinite without one.
[[nodiscard]] double nearest_person_m(const Hull& hull, const PeopleInput& people);

/// The speed limit from everything but the path ahead: SAF-1, SAF-2, unknown people, unknown brakes.
[[nodiscard]] double speed_limit_mps(const GateConfig& config, const Hull& hull, const PeopleInput& people,
                                     const BaseInput& base);

/// The limits of everything near on a motion.
struct PathLimit {
  Motion motion;  ///< what is left of it: the same arc, slower
  bool limited_to_zero = false;
};

/// SAF-2, SAF-3 and SAF-4: slows `wanted` down to what stops in front of every one of `points_in_base`.
///
/// `late_s` [s] is how much older than usual they are: time in which the robot drives blind.
[[nodiscard]] PathLimit limited_by_surroundings(const GateConfig& config, const Hull& hull, double deceleration_mps2,
                                                double late_s, const Motion& wanted,
                                                std::span<const Eigen::Vector2d> points_in_base);

}  // namespace tandem::safety
