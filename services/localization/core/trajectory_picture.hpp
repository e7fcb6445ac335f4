#pragma once

#include <span>
#include <string>

#include "services/localization/core/trajectory_file.hpp"
#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem {

/// The map with the estimated way on it (blue) and the true one below (orange), as an SVG file. Equal inputs, equal
/// bytes. `truth` may be empty.
[[nodiscard]] std::string trajectory_picture(const OccupancyGrid& map, std::span<const TimedPose> estimate,
                                             std::span<const TimedPose> truth);

}  // namespace tandem
