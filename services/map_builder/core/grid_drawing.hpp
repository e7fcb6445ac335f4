#pragma once

#include <functional>
#include <span>

#include "services/map_builder/core/drive_log.hpp"
#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem {

/// The map that `scans` draw from `poses`: each beam clears the cells that it crosses and hits the one where it ends; a
/// cell is occupied when beams ended in it at least in `occupied_share` of the cases.
///
/// `keep_going` hears the share done; with false the rest is left out. Throws MapError where there would be more cells
/// than load_map takes.
[[nodiscard]] OccupancyGrid drawn_grid(std::span<const MapScan> scans, std::span<const Pose2> poses,
                                       const MapBuilderConfig& config, const std::function<bool(double)>& keep_going);

}  // namespace tandem
