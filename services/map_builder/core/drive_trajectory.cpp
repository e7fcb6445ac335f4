#include "services/map_builder/core/drive_trajectory.hpp"

#include <algorithm>

namespace tandem {

std::vector<Pose2> scan_poses(const MapGraph& graph) {
  std::vector<Pose2> poses;
  poses.reserve(graph.places.size());
  for (std::size_t i = 0; i < graph.places.size(); ++i) {
    const ScanPlace& place = graph.places[i];
    const Pose2 from_before = graph.poses[place.node] * place.node_from_base;
    const std::size_t first = graph.nodes[place.node].scan;
    if (i == first || place.node + 1 == graph.nodes.size()) {
      poses.push_back(from_before);
      continue;
    }
    // As it was tracked: the next node seen from this one, and so this scan seen from the next node.
    const Pose2& node_from_next = graph.chain[place.node].from_pose_to_pose;
    const Pose2 from_after = graph.poses[place.node + 1] * (inverse(node_from_next) * place.node_from_base);
    const double share = static_cast<double>(i - first) / static_cast<double>(graph.nodes[place.node + 1].scan - first);
    poses.push_back(interpolate(from_before, from_after, share));
  }
  return poses;
}

std::vector<TimedPose> trajectory_between(std::span<const TimedPose> scan_poses, const OdometryTrack& odometry) {
  std::vector<TimedPose> trajectory;
  for (std::size_t i = 0; i < scan_poses.size(); ++i) {
    trajectory.push_back(scan_poses[i]);
    if (i + 1 == scan_poses.size()) break;
    const TimedPose& a = scan_poses[i];
    const TimedPose& b = scan_poses[i + 1];
    const auto at_a = odometry.at(a.time, Duration::max());
    const auto at_b = odometry.at(b.time, Duration::max());
    if (!at_a || !at_b || at_a->epoch != at_b->epoch) continue;
    const auto samples = odometry.samples();
    auto sample = std::upper_bound(samples.begin(), samples.end(), a.time,
                                   [](Time time, const OdometrySample& one) { return time < one.time; });
    for (; sample != samples.end() && sample->time < b.time; ++sample) {
      const Pose2 from_a = a.map_from_base * (inverse(at_a->odom_from_base) * sample->odom_from_base);
      const Pose2 from_b = b.map_from_base * (inverse(at_b->odom_from_base) * sample->odom_from_base);
      const double share = to_seconds(sample->time - a.time) / to_seconds(b.time - a.time);
      trajectory.push_back({sample->time, interpolate(from_a, from_b, share)});
    }
  }
  return trajectory;
}

}  // namespace tandem
