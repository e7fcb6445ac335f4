#pragma once

#include <span>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/common/random.hpp"
#include "services/simulator/core/robot_body.hpp"

namespace tandem::simulator {

/// One beam to be cast: where it points in the laser frame, and when within the turn.
struct Beam {
  double angle_rad = 0.0;
  double share_of_turn = 0.0;  ///< [0, 1]
};

/// What the sensor makes of true distances.
struct RangeModel {
  double min_m = 0.023;
  double max_m = 30.0;
  double noise_m = 0.01;  ///< standard deviation
};

/// The range of each beam [m], NaN where nothing comes back. The laser moves from `map_from_laser_at_start` to
/// `..._at_end` during the turn.
[[nodiscard]] std::vector<double> cast(std::span<const Beam> beams, const Pose2& map_from_laser_at_start,
                                       const Pose2& map_from_laser_at_end, const Place& place,
                                       std::span<const Disc> legs, const RangeModel& model, Rng& rng);

/// Distance [m] along a ray to the near side of `disc`; infinite if it is missed. 0 from inside.
[[nodiscard]] double range_to_disc_m(const Eigen::Vector2d& origin_in_map, double heading_rad, const Disc& disc);

}  // namespace tandem::simulator
