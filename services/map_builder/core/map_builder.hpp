#pragma once

#include <functional>
#include <string>
#include <vector>

#include "services/localization/core/trajectory_file.hpp"
#include "services/map_builder/core/drive_log.hpp"
#include "services/map_builder/core/map_builder_config.hpp"
#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem {

/// Two places on the way that are one.
struct MapClosure {
  TimedPose earlier;
  TimedPose later;
};

/// A map, and how it came about.
struct BuiltMap {
  OccupancyGrid grid;
  std::vector<TimedPose> scan_poses;  ///< of each scan used, in their order, with the recorded stamps
  std::vector<TimedPose> trajectory;  ///< of each scan and each odometry sample between scans, by recorded stamp
  std::vector<MapClosure> closures;   ///< believed to the end
  std::size_t rejected = 0;           ///< closures that did not agree with the rest
  std::size_t nodes = 0;              ///< of the graph
  bool complete = true;               ///< false: stopped early; the map is that of the scans until then
};

/// What the builder is at, and which share of the whole is done.
struct BuildProgress {
  const char* step = "";
  double share = 0.0;
};

/// Builds a map from what a robot measured; its first scan's pose is the map's origin. docs/mapping.md tells how.
///
/// Draws no random numbers: equal input gives equal output, bit for bit. `keep_going` hears the progress; after a false
/// no more scans are taken in, and what is there is drawn.
[[nodiscard]] BuiltMap build_map(const Drive& drive, const MapBuilderConfig& config,
                                 const std::function<bool(const BuildProgress&)>& keep_going);

/// Names the parameters.
[[nodiscard]] std::string hash_of(const MapBuilderConfig& config);

}  // namespace tandem
