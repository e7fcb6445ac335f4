#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "robot/safety/core/gate_config.hpp"
#include "robot/safety/core/speed_limits.hpp"
#include "robot/safety/core/swept_path.hpp"
#include "services/common/pose2.hpp"

namespace tandem::safety {

/// A polygon of the map that the gate minds whatever it is told: it lets the hull never in, or slowly.
struct HardZone {
  std::vector<Eigen::Vector2d> corners_in_map;  ///< A simple polygon, either way round [m].
  double max_speed_mps = 0.0;                   ///< 0: keep out.

  [[nodiscard]] bool is_keep_out() const { return max_speed_mps <= 0.0; }
};

/// Whether the hull at `map_from_base` and the zone have a point in common.
[[nodiscard]] bool overlaps(const Hull& hull, const Pose2& map_from_base, const HardZone& zone);

/// Slows `wanted` down to what stops before every keep-out zone, and enters and crosses slow ones no faster than they
/// allow. Inside a keep-out zone nothing moves, but an operator may creep (`may_creep`).
[[nodiscard]] PathLimit limited_by_zones(const GateConfig& config, const Hull& hull, double deceleration_mps2,
                                         const Motion& wanted, std::span<const HardZone> zones,
                                         const Pose2& map_from_base, bool may_creep);

}  // namespace tandem::safety
