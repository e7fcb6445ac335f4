#pragma once

#include <cstddef>
#include <vector>

#include "services/map_builder/core/drive_log.hpp"
#include "services/map_builder/core/map_builder_config.hpp"
#include "services/map_builder/core/pose_graph.hpp"
#include "services/map_builder/core/scan_registration.hpp"
#include "services/map_builder/core/surface_index.hpp"

namespace tandem {

/// A place on the way whose pose the graph finds.
struct MapNode {
  std::size_t scan = 0;  ///< index into the drive's scans
  double way_m = 0.0;    ///< driven until here
  SurfaceIndex surface;  ///< seen from the base
};

/// Where a scan was taken: from the node before it.
struct ScanPlace {
  std::size_t node = 0;
  Pose2 node_from_base;
};

/// The state of a map that is being built: poses of nodes, and what holds them together.
struct MapGraph {
  std::vector<MapNode> nodes;
  std::vector<Pose2> poses;        ///< of the nodes; the first scan is the map's origin
  std::vector<PoseEdge> chain;     ///< from each node to the next, as scans and wheels found together
  std::vector<PoseEdge> closures;  ///< between nodes that saw the same place at different times
  std::vector<ScanPlace> places;   ///< of each scan so far
  double way_m = 0.0;              ///< driven until the last of them
};

/// What `scan` saw, as a node keeps it.
[[nodiscard]] Surface surface_of(const MapScan& scan, const MapBuilderConfig& config);

/// Information that the wheels hold about `motion`, in the frame of its end.
[[nodiscard]] Eigen::Matrix3d information_of_wheels(const Pose2& motion, const MapBuilderConfig& config);

/// How scans are laid onto others.
[[nodiscard]] RegistrationOptions registration_options(const MapBuilderConfig& config);

}  // namespace tandem
