#pragma once

#include <localizationPubSubTypes.h>
#include <perceptionPubSubTypes.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/camera/core/place_confirmation.hpp"
#include "robot/camera/core/pose_history.hpp"

namespace tandem {

/// The pose in `message`; none while the robot is lost.
[[nodiscard]] std::optional<PoseHistory::Entry> from_message(const msg::RobotPose& message);

/// What `robot` found, as of `stamp`; the id is the caller's to give.
[[nodiscard]] msg::ObjectDetection to_message(const PlaceConfirmation::Confirmed& place, const std::string& robot,
                                              Time stamp, std::vector<std::uint8_t> jpeg);

}  // namespace tandem
