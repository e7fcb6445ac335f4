#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "services/recorder/core/ros_messages.hpp"

namespace tandem::recorder {

/// A message of a bag of ROS 1 or 2, its bytes still packed.
struct RosbagMessage {
  std::string topic;
  std::string type;
  ros::Wire wire = ros::Wire::Cdr;
  std::int64_t time_ns = 0;  ///< when it was recorded
  mcap::ByteView data;       ///< valid during the call
};

/// Gives each message of `bag`: a ROS 1 .bag, a rosbag2 file (.mcap or .db3), or a rosbag2 folder with any of these.
/// `on_message` false ends it. Throws std::runtime_error, with the file, for what is none of these or is damaged.
void read_rosbag(const std::filesystem::path& bag, const std::function<bool(const RosbagMessage&)>& on_message);

}  // namespace tandem::recorder
