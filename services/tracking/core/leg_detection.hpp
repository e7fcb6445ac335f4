#pragma once

#include <Eigen/Core>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/common/time.hpp"
#include "services/mapping/core/distance_field.hpp"
#include "services/tracking/core/tracking_config.hpp"

namespace tandem::tracking {

/// One turn of the laser.
struct LaserScan {
  Time stamp{};                ///< Of the first beam.
  double angle_min_rad = 0.0;  ///< Of the first beam in the laser frame, counter-clockwise positive.
  double angle_increment_rad = 0.0;
  double beam_interval_s = 0.0;
  double range_min_m = 0.0;
  double range_max_m = 0.0;
  std::vector<float> ranges_m;  ///< Not finite or outside the limits: no return.
  Pose2 base_from_laser;

  [[nodiscard]] Time end() const;  ///< Of the last beam.
};

/// A group of neighbouring returns that can be a leg.
struct Leg {
  Eigen::Vector2d centre_in_map{0.0, 0.0};
  double width_m = 0.0;  ///< Across the beams.
  double range_m = 0.0;
  bool body = false;  ///< As wide as two legs: a person by itself.
};

/// What can be a leg in `scan`, taken while the laser moved from `map_from_laser_at_start` to `..._at_end`.
///
/// With a `map` what its walls explain is left out; without one (null) a leg must stand in front of what is beside it
/// and be seen by at least three beams, and "map" is any frame the laser's poses are given in.
[[nodiscard]] std::vector<Leg> find_legs(const TrackingConfig& config, const LaserScan& scan,
                                         const Pose2& map_from_laser_at_start, const Pose2& map_from_laser_at_end,
                                         const DistanceField* map);

/// A person as seen in one scan.
struct Sighting {
  Eigen::Vector2d position_in_map{0.0, 0.0};
  double standard_deviation_m = 0.0;
  bool pair = false;  ///< Both legs, or a whole body.
};

/// Legs taken together into people: each with its nearest within a stride, closest pairs first; the rest alone.
[[nodiscard]] std::vector<Sighting> pair_legs(const TrackingConfig& config, const std::vector<Leg>& legs);

}  // namespace tandem::tracking
