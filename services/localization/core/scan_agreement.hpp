#pragma once

#include <Eigen/Core>
#include <span>

#include "services/common/pose2.hpp"
#include "services/mapping/core/distance_field.hpp"
#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem {

/// Share of the beams that the map explains with the base at `map_from_base`; 0 for none.
///
/// Such a beam ends within `fit_distance_m` of a wall, and on its way from the laser passes through none: a beam that
/// is too short may have met a person, one that comes out of a wall tells that the pose is wrong.
[[nodiscard]] double agreement_of(const OccupancyGrid& map, const DistanceField& distances, const Pose2& map_from_base,
                                  const Eigen::Vector2d& laser_in_base,
                                  std::span<const Eigen::Vector2d> endpoints_in_base, double fit_distance_m);

}  // namespace tandem
