#include "services/map_builder/core/drive_trajectory.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {
namespace {

constexpr double kMetresPerRadian = 0.5;

double size_of(const Pose2& motion) {
  return motion.position().norm() + kMetresPerRadian * std::abs(motion.heading);
}

}  // namespace

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

std::vector<TimedPose> trajectory_of(const Drive& drive, std::span<const Pose2> poses) {
  std::vector<TimedPose> trajectory;
  const OdometryTrack& odometry = drive.odometry;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const MapScan& a = drive.scans[i];
    trajectory.push_back({a.stamp, poses[i]});
    if (i + 1 == poses.size()) break;
    const MapScan& b = drive.scans[i + 1];
    const auto at_a = odometry.at(a.time, Duration::max());
    const auto at_b = odometry.at(b.time, Duration::max());
    if (!at_a || !at_b || at_a->epoch != at_b->epoch) continue;
    const auto samples = odometry.samples();
    const auto after_a = std::upper_bound(samples.begin(), samples.end(), a.time,
                                          [](Time time, const OdometrySample& one) { return time < one.time; });
    for (auto k = static_cast<std::size_t>(after_a - samples.begin()); k < samples.size(); ++k) {
      if (samples[k].time >= b.time) break;
      const Pose2 since_a = inverse(at_a->odom_from_base) * samples[k].odom_from_base;
      const Pose2 since_b = inverse(at_b->odom_from_base) * samples[k].odom_from_base;
      const double whole = size_of(since_a) + size_of(since_b);
      const double share = whole > 0.0 ? size_of(since_a) / whole : 0.0;
      trajectory.push_back({odometry.stamps()[k], interpolate(poses[i] * since_a, poses[i + 1] * since_b, share)});
    }
  }
  std::stable_sort(trajectory.begin(), trajectory.end(),
                   [](const TimedPose& one, const TimedPose& other) { return one.time < other.time; });
  return trajectory;
}

}  // namespace tandem
