#pragma once

#include <perceptionPubSubTypes.h>

#include <string>

#include "robot/laser/core/laser_reading.hpp"
#include "services/common/pose2.hpp"

namespace tandem {

/// `reading` as it travels, from the laser mounted at `base_from_laser` on `robot`.
[[nodiscard]] msg::LaserScan to_message(const LaserReading& reading, const std::string& robot,
                                        const Pose2& base_from_laser, std::uint64_t sequence_number);

/// The inverse of to_message, less what only the message knows.
[[nodiscard]] LaserReading from_message(const msg::LaserScan& message);

}  // namespace tandem
