#pragma once

#include <span>
#include <vector>

#include "services/localization/core/trajectory_file.hpp"
#include "services/map_builder/core/map_graph.hpp"
#include "services/map_builder/core/odometry_track.hpp"

namespace tandem {

/// Where each scan was taken: the nodes' poses, and between two nodes the way that was tracked, bent so that it ends at
/// the second.
[[nodiscard]] std::vector<Pose2> scan_poses(const MapGraph& graph);

/// The scans' poses, and between two scans the poses at which the wheels were read, by recorded stamp: as the wheels
/// say from the scan before and from the one after, more of the nearer. Where the wheels break between two scans
/// nothing is added. `poses` are those of the first scans of the drive.
[[nodiscard]] std::vector<TimedPose> trajectory_of(const Drive& drive, std::span<const Pose2> poses);

}  // namespace tandem
