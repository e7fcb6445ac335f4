#pragma once

#include <Eigen/Core>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/mapping/core/map_areas.hpp"

namespace tandem::navigator {

/// The hard zones of the map as whoever drives minds them; the safety gate has the last word on them.
class Zones {
 public:
  Zones() = default;
  explicit Zones(std::vector<MapArea> areas);

  /// Adds the outlines of keep-out zones near the robot to what is in its way.
  void add_outlines(const Pose2& map_from_base, std::vector<Eigen::Vector2d>& obstacles_in_base) const;
  /// The greatest speed [m/s] at which a hull within `hull_radius_m` of `position_in_map` is slow enough wherever a
  /// slow zone begins, braking with `deceleration_mps2`; infinite far from any.
  [[nodiscard]] double speed_limit_mps(const Eigen::Vector2d& position_in_map, double hull_radius_m,
                                       double deceleration_mps2) const;

 private:
  std::vector<MapArea> slow_;
  std::vector<Eigen::Vector2d> outlines_in_map_;  ///< of the keep-out zones, so dense that nothing gets through
};

}  // namespace tandem::navigator
