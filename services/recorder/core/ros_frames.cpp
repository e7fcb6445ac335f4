#include "services/recorder/core/ros_frames.hpp"

#include <algorithm>

namespace tandem::ros {
namespace {

constexpr int kLongestChain = 100;  ///< more is a circle

Placed composed(const Placed& a_from_b, const Placed& b_from_c) {
  Pose2 placed = b_from_c.pose;
  if (a_from_b.is_mirrored) placed = {placed.x, -placed.y, -placed.heading};
  return {a_from_b.pose * placed, a_from_b.is_mirrored != b_from_c.is_mirrored};
}

Placed inverted(const Placed& a_from_b) {
  Pose2 pose = inverse(a_from_b.pose);
  if (a_from_b.is_mirrored) pose = {pose.x, -pose.y, -pose.heading};
  return {pose, a_from_b.is_mirrored};
}

}  // namespace

void Frames::learn(const Transform& transform) {
  joints_.try_emplace(transform.child_frame,
                      Joint{transform.header.frame, {transform.parent_from_child, transform.is_upside_down}});
}

Frames::Rooted Frames::rooted(const std::string& frame) const {
  Rooted rooted{frame, {}};
  for (int i = 0; i < kLongestChain; ++i) {
    const auto joint = joints_.find(rooted.root);
    if (joint == joints_.end()) break;
    rooted = {joint->second.parent, composed(joint->second.parent_from_child, rooted.root_from_frame)};
  }
  return rooted;
}

std::optional<Placed> Frames::base_from(const std::string& base, const std::string& child) const {
  if (base == child) return Placed{};
  const Rooted of_base = rooted(base);
  const Rooted of_child = rooted(child);
  if (of_base.root != of_child.root) return std::nullopt;
  return composed(inverted(of_base.root_from_frame), of_child.root_from_frame);
}

LaserScan turned_up(LaserScan scan) {
  const double last = scan.angle_min_rad + scan.angle_increment_rad * static_cast<double>(scan.ranges_m.size() - 1);
  scan.angle_min_rad = -last;
  std::reverse(scan.ranges_m.begin(), scan.ranges_m.end());
  std::reverse(scan.intensities.begin(), scan.intensities.end());
  return scan;
}

}  // namespace tandem::ros
