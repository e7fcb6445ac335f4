#pragma once

#include <map>
#include <optional>
#include <string>

#include "services/recorder/core/ros_messages.hpp"

namespace tandem::ros {

/// Where a frame is in another, in the plane.
struct Placed {
  Pose2 pose;                ///< heading: of its x axis
  bool is_mirrored = false;  ///< it hangs upside down: what is to its left is to the right
};

/// The frames of a robot, as its first transforms told: for those that do not move against each other.
class Frames {
 public:
  void learn(const Transform& transform);
  /// Where `child` is in `base`, none if no chain of transforms joins them.
  [[nodiscard]] std::optional<Placed> base_from(const std::string& base, const std::string& child) const;

 private:
  struct Joint {
    std::string parent;
    Placed parent_from_child;
  };
  /// Where `frame` is in the frame that has no parent, and which that is.
  struct Rooted {
    std::string root;
    Placed root_from_frame;
  };
  [[nodiscard]] Rooted rooted(const std::string& frame) const;

  std::map<std::string, Joint> joints_;  ///< by child
};

/// `scan` as a laser that is the right way up would have seen it.
[[nodiscard]] LaserScan turned_up(LaserScan scan);

}  // namespace tandem::ros
