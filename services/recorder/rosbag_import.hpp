#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/recorder/core/mcap_writer.hpp"

namespace tandem::recorder {

/// What of a bag to import, and as whose.
struct RosbagOptions {
  std::string robot = "robot1";
  std::string scan_topic;      ///< Empty: the only one there is.
  std::string odometry_topic;  ///< Empty: the only one there is; without any, the transform of odom_frame is taken.
  std::string base_frame;      ///< Empty: the odometry's child frame, else base_link.
  std::string odom_frame = "odom";
};

/// What was imported.
struct RosbagCount {
  std::uint64_t scans = 0;
  std::uint64_t odometry = 0;
  std::uint64_t maps = 0;
  std::uint64_t broken = 0;              ///< messages that are not what their type says
  std::vector<std::string> lost_lasers;  ///< frames of scans that no transform places on the base: taken to be at it
};

/// Writes the laser scans, odometry and maps of a bag of ROS 1 or 2 as our topics `scan`, `odometry` and `map`.
///
/// Stamps are those of the messages, log times those of the bag. Where the laser is comes from the transforms; one that
/// hangs upside down is turned up. `keep_going` false ends it early. Throws std::runtime_error, saying what to choose,
/// when a bag has several topics of scans or odometry and none was named.
[[nodiscard]] RosbagCount import_rosbag(const std::filesystem::path& bag, const RosbagOptions& options,
                                        mcap::Writer& writer, const std::function<bool()>& keep_going);

}  // namespace tandem::recorder
