#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "services/recorder/core/mcap_records.hpp"

namespace tandem::cli {

/// A message of a standard schema of Foxglove, as JSON.
struct FoxgloveMessage {
  std::string topic;   ///< "/map"
  std::string schema;  ///< "foxglove.Grid"
  std::string json;
};

/// What a viewer of Foxglove's schemas shows for the message `payload` (CDR) of our topic `topic`, which came at
/// `log_time_ns`; nothing for topics that have no place in a scene, and for what is not well-formed.
///
/// Frames: `map`, and under it each robot by its name. Times are log times, which are the times of playing, so that
/// transforms and what hangs on them agree.
///
///  - map, belief -> Grid (coloured)       - robot_pose -> FrameTransform, and the robot in the scene
///  - scan -> PointCloud                   - team_plan, reward_source -> lines in the scene
///  - teammates, people, ground_truth, detection -> bodies and names in the scene
[[nodiscard]] std::vector<FoxgloveMessage> foxglove_messages(const std::string& topic, mcap::ByteView payload,
                                                             std::uint64_t log_time_ns);

}  // namespace tandem::cli
