#pragma once

#include <functional>
#include <string>

#include "services/map_builder/core/drive_log.hpp"
#include "services/recorder/core/mcap_reader.hpp"

namespace tandem::cli {

/// What a recording holds for a map, and for calibration.
struct RecordedDrive {
  Drive drive;
  double duration_s = 0.0;   ///< from its first scan to its last
  std::size_t odometry = 0;  ///< samples
  std::size_t damaged = 0;   ///< messages that could not be read, or hold no numbers
  Pose2 base_from_laser;     ///< of its first scan
  std::string model;         ///< of the robot, as it named itself; empty where the recording does not say
};

/// Reads odometry and scans of the first robot in the recording, in its order. `keep_going` hears the share done, and
/// ends the reading with false.
[[nodiscard]] RecordedDrive read_drive(mcap::Reader& recording, const MapBuilderConfig& config,
                                       const std::function<bool(double)>& keep_going);

}  // namespace tandem::cli
