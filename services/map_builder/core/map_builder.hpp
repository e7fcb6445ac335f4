#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "services/localization/core/trajectory_file.hpp"
#include "services/map_builder/core/build_state.hpp"
#include "services/map_builder/core/drive_log.hpp"
#include "services/map_builder/core/map_builder_config.hpp"
#include "services/map_builder/core/scan_tracker.hpp"
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
};

/// What the builder is at, and which share of the whole is done.
struct BuildProgress {
  const char* step = "";
  double share = 0.0;
};

/// A map on its way: a bounded piece of work at a time. However it is divided, and whether or not its state was written
/// down and read in between, the map is the same, bit for bit: nothing is drawn by chance.
class MapBuild {
 public:
  /// Begins, or goes on where `state` is. `drive` must outlive it.
  MapBuild(const Drive& drive, const MapBuilderConfig& config, BuildState state = {});

  /// Is all found, and only to be drawn?
  [[nodiscard]] bool is_done() const { return state_.stage == BuildStage::Drawing; }
  /// Takes in one scan, or the neighbours of one node, or moves all poses.
  void advance();
  [[nodiscard]] BuildProgress progress() const;
  /// With this another build of the same drive and configuration goes on where this one is.
  [[nodiscard]] const BuildState& state() const { return state_; }

  /// Once it is done: the map. `keep_going` hears the progress; after a false there is none.
  [[nodiscard]] std::optional<BuiltMap> drawn(const std::function<bool(const BuildProgress&)>& keep_going) const;

 private:
  void take_in_next_scan();
  void settle();

  const Drive& drive_;
  MapBuilderConfig config_;
  BuildState state_;
  ScanTracker tracker_;
  ClosureFinder finder_;
};

/// Builds a map from what a robot measured, at one go; its first scan's pose is the map's origin. docs/mapping.md tells
/// how.
[[nodiscard]] BuiltMap build_map(const Drive& drive, const MapBuilderConfig& config);

/// Names the parameters.
[[nodiscard]] std::string hash_of(const MapBuilderConfig& config);

}  // namespace tandem
